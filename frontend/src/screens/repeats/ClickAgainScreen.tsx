/** Ten measurements to click again, one after the other, without their points; Esc stops, Ctrl+Z takes the last back. */
import { useMemo } from "preact/hooks";
import { Button, Empty, Loading } from "../../components";
import { CommandButton } from "../../components/CommandButton";
import { Said } from "../../components/Said";
import { historyCommands } from "../../components/undoTools";
import { navigate, query } from "../../core/address";
import { useCommands } from "../../core/commands";
import { say } from "../../core/messages";
import type { ScreenProps } from "../../core/places";
import { TARGET_WORDS, vehicleName } from "../../core/words";
import { FailedPage } from "../../parts/FailedPage";
import { usePageModel } from "../../parts/pageModel";
import { BlindFrame } from "../../viewer/BlindFrame";
import { frameCommands } from "../../viewer/stageCommands";
import { Transport } from "../../viewer/Transport";
import { AgainSession } from "./session";
import "./repeats.css";

export default function ClickAgainScreen({ surveyId }: ScreenProps) {
  const onlyOwn = query.value.get("of") !== "all";
  const session = usePageModel(() => new AgainSession(surveyId, onlyOwn), [surveyId, onlyOwn]);
  const results = `/surveys/${surveyId}/repeats`;
  const { undo, redo } = useMemo(() => commandsOf(session), [session]);
  useCommands([
    undo,
    redo,
    ...frameCommands(session.stage, session.reel.player.value),
    { id: "cancel", label: say("again-stop"), run: () => navigate(results) },
  ]);
  const items = session.items.value;
  const player = session.reel.player.value;
  if (session.problem.value) return <FailedPage model={session} />;
  if (items === null) return <Loading what={say("again-loading")} />;
  const item = session.current.value;
  if (items.length === 0) return <NothingToClick surveyId={surveyId} onlyOwn={onlyOwn} />;
  return (
    <div class="desk again">
      <h1 class="visually-hidden">{say("page-click-again")}</h1>
      <header class="row desk__head">
        <p data-testid="again-progress">
          {item ? (
            <Said
              what="again-place"
              values={{
                at: session.at.value + 1,
                of: items.length,
                vehicle: vehicleName(item.vehicle_number),
                target: TARGET_WORDS[item.target],
              }}
            />
          ) : (
            <strong>{say("again-stored", { count: session.stored.value })}</strong>
          )}
        </p>
        <span class="grow" />
        <CommandButton command={undo} kind="plain">
          {say("again-undo")}
        </CommandButton>
        {item && <Button says="again-skip" small onClick={() => session.skip()} />}
        <Button
          says={item ? "again-stop" : "again-results"}
          small
          kind={item ? "quiet" : "primary"}
          href={results}
        />
      </header>
      {item && player ? (
        <>
          <section class="frame-place" aria-label={say("stage-frame")}>
            <BlindFrame
              key={player.recordingId}
              blind={session.blind}
              player={player}
              stage={session.stage}
            />
          </section>
          <section
            class="desk__time desk__time--low row row--near frame-tools"
            aria-label={say("stage-frames")}
          >
            <Transport player={player} stage={session.stage} />
            <span class="grow" />
            {player.shown.value?.frame !== item.frame && (
              <Button small onClick={() => session.showFrame()}>
                {say("again-back-to-frame", { frame: String(item.frame) })}
              </Button>
            )}
          </section>
        </>
      ) : (
        <Empty says="again-last-title" why="again-last" />
      )}
    </div>
  );
}

function NothingToClick({ surveyId, onlyOwn }: { surveyId: number; onlyOwn: boolean }) {
  return (
    <div class="page">
      <h1 class="visually-hidden">{say("page-click-again")}</h1>
      <Empty
        says={onlyOwn ? "again-none-own-title" : "again-none-title"}
        why={onlyOwn ? "again-none-own" : "again-none"}
        actions={
          <>
            {onlyOwn && (
              <Button
                says="repeats-click-anybodys"
                kind="primary"
                href={`/surveys/${surveyId}/repeats/click?of=all`}
              />
            )}
            <Button says="again-to-measure" href={`/surveys/${surveyId}/measure`} />
          </>
        }
      />
    </div>
  );
}

function commandsOf(session: AgainSession) {
  return historyCommands(session.history, {
    back: () => session.stage.back() || session.blind.busy.value,
    inHand: () => session.blind.contact.value !== null,
  });
}
