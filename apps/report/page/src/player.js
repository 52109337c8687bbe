/** What is shown when: a frame and the part of the way to the next one. */
export class Player {
  playing = false;
  rate = 1;
  frame = 0;
  fraction = 0;
  #frames;
  #onChange;
  #last;

  /** onChange() is called whenever frame, fraction or playing change. */
  constructor(frames, onChange) {
    this.#frames = frames;
    this.#onChange = onChange;
  }

  /** s, simulated. */
  get time() {
    const { times } = this.#frames;
    const next = times[Math.min(this.frame + 1, times.length - 1)];
    return times[this.frame] + this.fraction * (next - times[this.frame]);
  }
  get #end() {
    return this.#frames.ready - 1;
  }

  show(frame) {
    this.frame = Math.max(0, Math.min(frame, this.#end));
    this.fraction = 0;
    this.#onChange();
  }

  step(frames) {
    this.playing = false;
    this.show(frames < 0 && this.fraction > 0 ? this.frame : this.frame + frames);
  }

  showTime(time) {
    const { times } = this.#frames;
    let nearest = 0;
    times.forEach((t, i) => {
      if (Math.abs(t - time) < Math.abs(times[nearest] - time)) nearest = i;
    });
    this.playing = false;
    this.show(nearest);
  }

  toggle() {
    this.playing = !this.playing && this.#frames.count > 1;
    if (this.playing) {
      if (this.frame >= this.#frames.count - 1) this.frame = this.fraction = 0;
      this.#last = undefined;
      requestAnimationFrame((now) => this.#tick(now));
    }
    this.#onChange();
  }

  #tick(now) {
    if (!this.playing) return;
    const seconds = this.#last === undefined ? 0 : (now - this.#last) / 1000;
    this.#last = now;
    this.#advance(Math.min(seconds, 0.25) * this.rate);
    this.#onChange();
    requestAnimationFrame((next) => this.#tick(next));
  }

  /** At the end of the run it begins anew; it waits for frames that have not arrived yet. */
  #advance(seconds) {
    const { times } = this.#frames;
    const time = this.time + seconds;
    while (this.frame < this.#end && times[this.frame + 1] <= time) ++this.frame;
    if (this.frame < this.#end) {
      this.fraction = (time - times[this.frame]) / (times[this.frame + 1] - times[this.frame]);
    } else {
      this.fraction = 0;
      if (this.#end === this.#frames.count - 1) this.frame = 0;
    }
  }
}
