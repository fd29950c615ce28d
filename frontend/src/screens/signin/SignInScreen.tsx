import { useEffect } from "preact/hooks";
import { Button, Loading, Mark, Notice, TextField } from "../../components";
import { useAction } from "../../core/action";
import { navigate, query } from "../../core/address";
import { ApiError, api, explain } from "../../core/api";
import { say } from "../../core/messages";
import { enter, me, safeNext } from "../../core/session";
import { formatHeight } from "../../core/units";
import "./signin.css";
import { sent, useForm } from "../../core/form";

/** Signs in with a one-time link (`/sign-in?token=...`) or with e-mail and password. */
export default function SignInScreen() {
  const token = query.value.get("token");
  return (
    <main class="signin" id="main">
      <div class="stack signin__card">
        <div class="row row--far signin__mark">
          <Mark size={32} />
          <span>{say("app-name")}</span>
        </div>
        {token ? <LinkSignIn token={token} /> : <PasswordSignIn />}
      </div>
      <SightDrawing />
    </main>
  );
}

/** The link signs in by itself; only what goes wrong needs a word. */
function LinkSignIn({ token }: { token: string }) {
  const { problem, run } = useAction();
  const go = () =>
    run(async () => {
      const answer = await api.ask("POST /session/link", {}, { body: { token }, allowSignedOut: true });
      enter(answer, safeNext(query.value.get("next")));
    });
  useEffect(() => void go(), []);
  if (problem === null) return <Loading what={say("signin-loading")} />;
  const used = problem instanceof ApiError && problem.status === 401;
  return (
    <>
      <h1>{say("signin-link-title")}</h1>
      <Notice kind="problem">{explain(problem)}</Notice>
      {used ? (
        <Button says="signin-with-password" href="/sign-in" />
      ) : (
        <Button says="action-try-again" kind="primary" onClick={() => void go()} />
      )}
    </>
  );
}

function PasswordSignIn() {
  const form = useForm({ email: "", password: "" });
  const { email, password } = form.values;
  const { busy, problem, run } = useAction();
  useEffect(() => {
    if (me.value) navigate("/", { replace: true });
  }, []);
  const submit = () =>
    run(async () => {
      const answer = await api.ask("POST /session", {}, { body: { email, password }, allowSignedOut: true });
      enter(answer, safeNext(query.value.get("next")));
    });
  return (
    <form class="stack" onSubmit={sent(submit)}>
      <h1>{say("page-sign-in")}</h1>
      {problem !== null && <Notice kind="problem">{explain(problem)}</Notice>}
      <TextField says="signin-email" type="email" {...form.field("email")} autoComplete="username" required />
      <TextField
        says="signin-password"
        type="password"
        {...form.field("password")}
        autoComplete="current-password"
        required
      />
      <Button says="signin-submit" kind="primary" type="submit" busy={busy} />
      <p class="field__hint">{say("signin-help")}</p>
    </form>
  );
}

/** What the product does in one drawing: lines of sight from the camera over a car's roof, the eye and the light to the side plane. */
function SightDrawing() {
  return (
    <svg
      class="signin__drawing"
      viewBox="-24 20 744 700"
      fill="none"
      aria-hidden="true"
      preserveAspectRatio="xMidYMid meet"
    >
      <g stroke="var(--stage-line)" stroke-width="1">
        {Array.from({ length: 14 }, (_, i) => (
          <path key={`h${i}`} d={`M-400 ${520 + i * i * 3.4}H1120`} />
        ))}
        {Array.from({ length: 25 }, (_, i) => (
          <path key={`v${i}`} d={`M${360 + (i - 12) * 60} 520L${360 + (i - 12) * 330} 1174`} />
        ))}
      </g>
      <g stroke="var(--stage-ink-2)" stroke-width="2" stroke-linejoin="round">
        <path d="M214 520l4-46c2-14 8-20 22-24l62-12 54-52c8-8 16-11 28-11h108c14 0 22 4 30 15l34 50 34 12c12 4 16 10 17 22l4 46" />
        <path d="M332 438l42-42c4-4 8-6 14-6h38v48zM440 390h46c8 0 14 3 19 10l24 38h-89z" />
        <path d="M214 520h52M338 520h158M568 520h45" />
        <circle cx="302" cy="520" r="34" />
        <circle cx="302" cy="520" r="16" />
        <circle cx="532" cy="520" r="34" />
        <circle cx="532" cy="520" r="16" />
        <path d="M586 462h24" />
        <circle cx="404" cy="416" r="10" />
      </g>
      <g stroke="var(--accent)" stroke-width="1.5">
        <path d="M40 150L430 374" stroke-dasharray="1 7" stroke-linecap="round" />
        <path d="M40 150L404 416" stroke-dasharray="1 7" stroke-linecap="round" />
        <path d="M40 150L302 554" stroke-dasharray="1 7" stroke-linecap="round" />
        <path d="M656 554V374" />
        {Array.from({ length: 17 }, (_, i) => (
          <path key={i} d={`M656 ${554 - i * 11.25}h${i % 4 === 0 ? 12 : 6}`} />
        ))}
      </g>
      <g fill="var(--accent)">
        <circle cx="40" cy="150" r="5" />
        <circle cx="430" cy="374" r="4" />
        <circle cx="404" cy="416" r="4" />
        <circle cx="302" cy="554" r="4" />
        <circle cx="598" cy="462" r="4" />
      </g>
      <g fill="var(--stage-ink)" font-size="15" style="font-variant-numeric: tabular-nums">
        <text x="700" y="358" text-anchor="end">
          {formatHeight(1.618, 0.013)}
        </text>
      </g>
    </svg>
  );
}
