import { Panel } from "../../components";
import { say } from "../../core/messages";

/** What to do about a plan, what matters most first. */
export function Advice({ sentences }: { sentences: readonly string[] }) {
  return (
    <Panel title={say("planning-advice")}>
      <ul class="panel__body plan-advice">
        {sentences.map((sentence) => (
          <li key={sentence}>{sentence}</li>
        ))}
      </ul>
    </Panel>
  );
}
