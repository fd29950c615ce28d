import { Panel } from "../../components";
import { type Said, sentenceOf } from "../../core/messages";

export function Advice({ advice }: { advice: readonly Said[] }) {
  return (
    <Panel says="planning-advice">
      <ul class="panel__body stack stack--near words plan-advice">
        {advice.map(sentenceOf).map((sentence) => (
          <li key={sentence}>{sentence}</li>
        ))}
      </ul>
    </Panel>
  );
}
