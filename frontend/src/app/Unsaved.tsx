/** What the server refused, or somebody else changed meanwhile: both values, and the choice. Nothing is lost before it is made. */
import { Button, Icon } from "../components";
import { Said } from "../components/Said";
import { current, query } from "../core/address";
import { outbox, type Wish } from "../core/outbox";

export function Unsaved() {
  const open = [...outbox.wishes.value.values()].filter((wish) => isOpen(wish) && !isShownThere(wish));
  if (open.length === 0) return null;
  return (
    <div class="stack stack--tight unsaved" role="alert" data-testid="unsaved">
      {open.map((wish) => (
        <div key={wish.key} class="row row--wrap">
          <Icon name="warning" />
          <span class="grow">
            <Told wish={wish} />
          </span>
          {wish.state === "conflict" ? <Choice wish={wish} /> : <Again wish={wish} />}
        </div>
      ))}
    </div>
  );
}

function Choice({ wish }: { wish: Wish }) {
  return (
    <>
      <Button says="unsaved-take" small onClick={() => outbox.resolve(wish.key, "theirs")} />
      <Button says="unsaved-keep" small onClick={() => outbox.resolve(wish.key, "mine")} />
    </>
  );
}

function Again({ wish }: { wish: Wish }) {
  return (
    <>
      <Button says="unsaved-again" small onClick={() => outbox.send(wish.key)} />
      <Button says="unsaved-drop" small onClick={() => outbox.discard(wish.key)} />
    </>
  );
}

function Told({ wish }: { wish: Wish }) {
  const { what, mine } = wish;
  const told = { what, mine, problem: wish.problem ?? "" };
  const parts = { link: (text: string) => <a href={wish.page}>{text}</a> };
  if (wish.state === "failed") return <Said what="unsaved-refused" values={told} parts={parts} />;
  const theirs = outbox.theirs(wish);
  return <Said what="unsaved-conflict" values={{ ...told, theirs }} parts={parts} />;
}

function isOpen({ state }: Wish): boolean {
  return state === "conflict" || state === "failed";
}

/** Measure shows beside the open vehicle what is of it. What one has gone on from is shown here. */
function isShownThere({ page }: Wish): boolean {
  const here = current.value;
  if (here?.place.name !== "measure") return false;
  return page === `/surveys/${here.surveyId}/measure?vehicle=${query.value.get("vehicle")}`;
}
