/** What hands have done since a vehicle was opened. */
export class Hands {
  /** A key that is held down confirms one vehicle, not every one after it. */
  armed = true;
  /** Somebody has pressed or clicked since the vehicle was opened. */
  touched = false;
  private readonly ends = new AbortController();

  constructor() {
    const { signal } = this.ends;
    const touch = (): void => {
      this.touched = true;
    };
    const arm = (): void => {
      this.armed = true;
    };
    window.addEventListener("keyup", arm, { signal });
    window.addEventListener("keydown", touch, { capture: true, signal });
    window.addEventListener("pointerdown", touch, { capture: true, signal });
  }

  close(): void {
    this.ends.abort();
  }
}
