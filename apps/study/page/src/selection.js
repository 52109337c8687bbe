/** How many variants can be selected at a time; each has a colour of its own among the lines. */
export const mostSelected = 8;

/** Which variant the reader points at and which are selected; tells listeners of every change. */
export class Selection extends EventTarget {
  hovered = null;
  #slots = Array(mostSelected).fill(null);

  /** Names in the order of their slots. */
  get names() {
    return this.#slots.filter((name) => name !== null);
  }
  /** The number of the colour of a name, or -1. */
  slot(name) {
    return this.#slots.indexOf(name);
  }
  has(name) {
    return this.slot(name) >= 0;
  }

  hover(name) {
    if (name === this.hovered) return;
    this.hovered = name;
    this.#tell();
  }
  /** Of more than mostSelected the last takes the place of the first. */
  toggle(name) {
    const free = this.#slots.indexOf(null);
    if (this.has(name)) this.#slots[this.slot(name)] = null;
    else if (free >= 0) this.#slots[free] = name;
    else this.#slots = [...this.#slots.slice(1), name];
    this.#tell();
  }
  replace(names) {
    this.#slots.fill(null);
    names.slice(0, mostSelected).forEach((name, slot) => { this.#slots[slot] = name; });
    this.#tell();
  }

  #tell() {
    this.dispatchEvent(new Event('change'));
  }
}
