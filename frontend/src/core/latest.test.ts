import { describe, expect, it } from "vitest";
import { Latest } from "./latest";

function harness() {
  const asked: number[] = [];
  const answers: number[] = [];
  const errors: unknown[] = [];
  const pending: { resolve(): void; reject(error: Error): void }[] = [];
  const latest = new Latest<number, number>(
    (wish) =>
      new Promise((resolve, reject) => {
        asked.push(wish);
        pending.push({ resolve: () => resolve(wish * 10), reject });
      }),
    (answer) => answers.push(answer),
    (error) => errors.push(error),
  );
  const settle = () => new Promise((done) => setTimeout(done));
  return { latest, asked, answers, errors, pending, settle };
}

describe("Latest", () => {
  it("asks for the newest wish only, one at a time", async () => {
    const { latest, asked, answers, pending, settle } = harness();
    for (const wish of [1, 2, 3, 4]) latest.want(wish);
    expect(asked).toEqual([1]);
    pending[0]?.resolve();
    await settle();
    expect(asked).toEqual([1, 4]);
    pending[1]?.resolve();
    await settle();
    expect(answers).toEqual([10, 40]);
  });

  it("does not tell an answer nobody waits for any more", async () => {
    const { latest, answers, pending, settle } = harness();
    latest.want(1);
    latest.cancel();
    pending[0]?.resolve();
    await settle();
    expect(answers).toEqual([]);
  });

  it("goes on after an error", async () => {
    const { latest, answers, errors, pending, settle } = harness();
    latest.want(1);
    latest.want(2);
    pending[0]?.reject(new Error("offline"));
    await settle();
    pending[1]?.resolve();
    await settle();
    expect(errors).toHaveLength(1);
    expect(answers).toEqual([20]);
  });
});
