// Lines and words of a text model, straight from its bytes: files of 100 MB become no strings, and every byte is looked at once.

import { decodeText, ModelError } from "./named-file";

const TAB = 9;
const LF = 10;
const CR = 13;
const SPACE = 32;
const HASH = 35;
const BACKSLASH = 92;
const [PLUS, MINUS, DOT, ZERO, NINE] = [43, 45, 46, 48, 57];
/** Bytes between two words of progress. */
const TOLD_EACH = 1 << 20;
/** Those that double precision holds exactly. */
const POWERS = Array.from({ length: 23 }, (_, n) => Number(`1e${n}`));

export class TextScanner {
  /** Of the current word, from 1. */
  line = 0;
  private readonly bytes: Uint8Array;
  /** Where to look for the next word. */
  private at = 0;
  private start = 0;
  private end = 0;
  private lineAt = 1;
  private begun = false;
  /** Where the next word of progress is due. */
  private told = TOLD_EACH;

  /** Errors (ModelError): the bytes are no text. */
  constructor(
    private readonly name: string,
    bytes: Uint8Array,
    kind: string,
    private readonly onProgress?: (done: number) => void,
  ) {
    this.bytes = plainText(name, bytes, kind);
  }

  /** Goes to the next line that holds a word; false where there is none. */
  nextLine(): boolean {
    const { bytes } = this;
    for (;;) {
      if (this.begun) {
        while (this.at < bytes.length && !isEnd(bytes[this.at])) this.at++;
        if (this.at >= bytes.length) return false;
        this.passEnd();
      }
      this.begun = true;
      if (this.at >= this.told) this.tell();
      if (this.peek()) {
        this.line = this.lineAt;
        return true;
      }
    }
  }

  /** Takes the next word of this line; false where it ends. */
  next(): boolean {
    if (!this.peek()) return false;
    this.line = this.lineAt;
    const { bytes } = this;
    this.start = this.at;
    while (this.at < bytes.length && !isBlank(bytes[this.at]) && !isEnd(bytes[this.at]) && !this.continues()) this.at++;
    this.end = this.at;
    return true;
  }

  /** Takes the next word of this line or of those that follow; false at the end of the file. */
  nextAnywhere(): boolean {
    return this.next() || (this.nextLine() && this.next());
  }

  /** Gives the word back: it is the next one once more. */
  again(): void {
    this.at = this.start;
  }

  /** The word that was taken. */
  word(): string {
    return this.text(this.start, this.end);
  }

  /** Whether the word is this one, which has small letters alone; with `anyCase`, in large ones too. */
  is(word: string, anyCase = false): boolean {
    if (this.end - this.start !== word.length) return false;
    for (let k = 0; k < word.length; k++) {
      const byte = this.bytes[this.start + k];
      if (byte !== word.charCodeAt(k) && !(anyCase && byte + 32 === word.charCodeAt(k))) return false;
    }
    return true;
  }

  /** The rest of the line, without blanks around it. */
  rest(): string {
    const from = this.at;
    while (this.next());
    return this.text(from, this.at).trim();
  }

  /** The word as a number; NaN if it is none. */
  number(): number {
    return this.numberIn(this.start, this.end);
  }

  /** The word's parts between slashes as whole numbers, 0 for an empty one; answers how many there are. NaN for what is no number. */
  indices(out: Float64Array): number {
    let parts = 0;
    let from = this.start;
    for (let k = this.start; k <= this.end && parts < out.length; k++) {
      if (k < this.end && this.bytes[k] !== 47) continue;
      const x = k === from ? 0 : this.numberIn(from, k);
      out[parts++] = Number.isInteger(x) ? x : NaN;
      from = k + 1;
    }
    return parts;
  }

  /** The most bytes that can hold words. */
  left(): number {
    return this.bytes.length - this.at;
  }

  error(what: string): ModelError {
    return new ModelError(`${this.name}, line ${this.line}: ${what}.`);
  }

  noNumber(): ModelError {
    return this.error(`"${shortened(this.word())}" is not a number`);
  }

  private tell(): void {
    this.onProgress?.(this.at / this.bytes.length);
    this.told = this.at + TOLD_EACH;
  }

  private text(from: number, to: number): string {
    return new TextDecoder().decode(this.bytes.subarray(from, to));
  }

  /** Passes blanks, comments and line ends that a backslash takes away; whether a word begins there. */
  private peek(): boolean {
    const { bytes } = this;
    for (;;) {
      while (this.at < bytes.length && isBlank(bytes[this.at])) this.at++;
      if (bytes[this.at] === HASH) while (this.at < bytes.length && !isEnd(bytes[this.at])) this.at++;
      if (!this.continues()) return this.at < bytes.length && !isEnd(bytes[this.at]);
      this.at++;
      this.passEnd();
    }
  }

  private continues(): boolean {
    return this.bytes[this.at] === BACKSLASH && this.at + 1 < this.bytes.length && isEnd(this.bytes[this.at + 1]);
  }

  private passEnd(): void {
    if (this.at >= this.bytes.length) return;
    this.at += this.bytes[this.at] === CR && this.bytes[this.at + 1] === LF ? 2 : 1;
    this.lineAt++;
  }

  private numberIn(from: number, to: number): number {
    const { bytes } = this;
    let k = from;
    const negative = bytes[k] === MINUS;
    if (negative || bytes[k] === PLUS) k++;
    let mantissa = 0;
    let digits = 0;
    let exponent = 0;
    let point = false;
    for (; k < to; k++) {
      const byte = bytes[k];
      if (byte >= ZERO && byte <= NINE) {
        mantissa = 10 * mantissa + (byte - ZERO);
        digits++;
        if (point) exponent--;
      } else if (byte === DOT && !point) point = true;
      else break;
    }
    if (digits === 0) return NaN;
    if (k < to && (bytes[k] | 32) === 101) {
      let power = 0;
      const down = bytes[++k] === MINUS;
      if (down || bytes[k] === PLUS) k++;
      if (k >= to) return NaN;
      for (; k < to && bytes[k] >= ZERO && bytes[k] <= NINE; k++) power = Math.min(10 * power + (bytes[k] - ZERO), 9999);
      exponent += down ? -power : power;
    }
    if (k < to) return NaN;
    if (mantissa <= Number.MAX_SAFE_INTEGER && Math.abs(exponent) <= 22) {
      const x = exponent < 0 ? mantissa / POWERS[-exponent] : mantissa * POWERS[exponent];
      return negative ? -x : x;
    }
    return Number(this.text(from, to));
  }
}

/** A word of a file as a sentence can hold it. */
export function shortened(word: string): string {
  return word.length > 20 ? `${word.slice(0, 20)}…` : word;
}

function isBlank(byte: number): boolean {
  return byte === SPACE || byte === TAB || byte === 11 || byte === 12;
}

function isEnd(byte: number): boolean {
  return byte === LF || byte === CR;
}

/** UTF-8 without its mark. */
function plainText(name: string, bytes: Uint8Array, kind: string): Uint8Array {
  if ((bytes[0] === 0xff && bytes[1] === 0xfe) || (bytes[0] === 0xfe && bytes[1] === 0xff)) {
    return new TextEncoder().encode(decodeText(bytes) ?? "");
  }
  if (decodeText(bytes.subarray(0, 4096)) === null) throw new ModelError(`${name} is not text, so it is no ${kind} model.`);
  return bytes[0] === 0xef && bytes[1] === 0xbb && bytes[2] === 0xbf ? bytes.subarray(3) : bytes;
}
