/**
 * One request in flight, the latest wish wins: what a moving pointer needs.
 * Wishes in between are skipped, so that the server answers the pointer and not its history.
 */
export class Latest<Wish, Answer> {
  private next: { wish: Wish } | null = null;
  private busy = false;
  private stamp = 0;

  constructor(
    private readonly ask: (wish: Wish) => Promise<Answer>,
    private readonly tell: (answer: Answer, wish: Wish) => void,
    private readonly fail: (error: unknown) => void = () => {},
  ) {}

  want(wish: Wish): void {
    this.next = { wish };
    if (!this.busy) void this.run();
  }

  cancel(): void {
    this.next = null;
    this.stamp += 1;
  }

  private async run(): Promise<void> {
    this.busy = true;
    while (this.next) {
      const { wish } = this.next;
      this.next = null;
      const stamp = this.stamp;
      try {
        const answer = await this.ask(wish);
        if (stamp === this.stamp) this.tell(answer, wish);
      } catch (error) {
        if (stamp === this.stamp) this.fail(error);
      }
    }
    this.busy = false;
  }
}
