// A name taken apart into words, in any script. The twin of include/rigless/motion/detail/name_words.h.

/** Full-width letters and digits become plain ones. */
function codePoints(text: string): number[] {
  return Array.from(text, (letter) => {
    const c = letter.codePointAt(0) ?? 0;
    return c >= 0xff01 && c <= 0xff5e ? c - 0xfee0 : c;
  });
}

type Letter = "none" | "digit" | "small" | "capital" | "wide";

/** `wide`: scripts that are written without spaces. */
function letterKind(c: number): Letter {
  const within = (first: number, end: number): boolean => c >= first && c < end;
  if (within(0x30, 0x3a)) return "digit";
  if (within(0x61, 0x7b) || within(0xdf, 0x410) || within(0x430, 0x2000)) return "small";
  if (within(0x41, 0x5b) || within(0xc0, 0xdf) || within(0x410, 0x430)) return "capital";
  return c >= 0x2e80 && !within(0x3000, 0x3005) && !within(0x3008, 0x3030) ? "wide" : "none";
}

/**
 * Split at what is no letter or digit, between letters and digits, and where a capital begins a word: "LHipJoint2" is l hip
 * joint 2. A name space in front is left out. Latin letters become small.
 */
export function nameWords(name: string): string[] {
  const space = Math.max(name.lastIndexOf(":"), name.lastIndexOf("|"));
  const letters = codePoints(space + 1 < name.length ? name.slice(space + 1) : name);
  const words = [""];
  let before: Letter = "none";
  letters.forEach((c, i) => {
    const kind = letterKind(c);
    const after = i + 1 < letters.length ? letterKind(letters[i + 1]) : "none";
    const wordGoesOn = kind === before || (before === "capital" && kind === "small");
    const lastCapital = kind === "capital" && before === "capital" && after === "small";
    if (!wordGoesOn || lastCapital) words.push("");
    if (kind !== "none") words[words.length - 1] += String.fromCodePoint(c >= 0x41 && c <= 0x5a ? c + 32 : c);
    before = kind;
  });
  return words.filter((word) => word !== "");
}

/** U+00E0 to U+00FF without accents. */
const BASE = "aaaaaaaceeeeiiiidnooooo/ouuuuypy";

/** For comparing: small letters, Latin ones without accents. */
export function plain(word: string): string {
  return codePoints(word)
    .map((c) => ((c >= 0xc0 && c < 0xdf) || (c >= 0x410 && c < 0x430) ? c + 32 : c))
    .map((c) => (c === 0xdf ? "ss" : c >= 0xe0 && c <= 0xff ? BASE[c - 0xe0] : String.fromCodePoint(c)))
    .join("");
}

export const isNumber = (word: string): boolean => /^[0-9]/.test(word);

/** Bytes of UTF-8, as the core counts. */
export function sizeOf(text: string): number {
  let size = 0;
  for (let i = 0; i < text.length; i++) {
    const c = text.charCodeAt(i);
    size += c < 0x80 ? 1 : c < 0x800 || (c >= 0xd800 && c < 0xe000) ? 2 : 3; // of four bytes each surrogate is two
  }
  return size;
}
