/** A list whose members keep their numbers: what is new takes places that became free, and what stays free holds a stand-in. */
export class Numbered<T> {
  private readonly members: (T | null)[];
  private next = 0;

  constructor(
    members: readonly (T | null)[],
    private readonly standIn: T,
  ) {
    this.members = [...members];
  }

  add(member: T): number {
    while (this.next < this.members.length && this.members[this.next] !== null) this.next++;
    this.members[this.next] = member;
    return this.next;
  }

  each(call: (member: T, number: number) => void): void {
    this.members.forEach((member, number) => void (member !== null && call(member, number)));
  }

  /** Without free places at the end. */
  list(): T[] {
    let length = this.members.length;
    while (length > 0 && this.members[length - 1] === null) length--;
    return this.members.slice(0, length).map((member) => member ?? this.standIn);
  }
}
