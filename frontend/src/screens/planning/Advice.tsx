import { say } from "../../core/messages";

/** What to do about a plan, what matters most first. */
export function Advice({ sentences }: { sentences: readonly string[] }) {
  return (
    <section class="panel" aria-labelledby="plan-advice">
      <div class="panel__head">
        <h2 id="plan-advice">{say("planning-advice")}</h2>
      </div>
      <ul class="panel__body plan-advice">
        {sentences.map((sentence) => (
          <li key={sentence}>{sentence}</li>
        ))}
      </ul>
    </section>
  );
}
