/** What the server's own description says of its routes, so that each call is checked. Types only. */
import type { paths } from "#schema";

type Method = "get" | "post" | "put" | "patch" | "delete";

type WithMethod<P extends keyof paths, Rest extends string> = {
  [M in Method]: paths[P][M] extends { responses: unknown } ? `${Uppercase<M>} ${Rest}` : never;
}[Method];

/** Every route, written as `GET /surveys/{survey_id}`. */
export type Route = {
  [P in keyof paths]: P extends `/api${infer Rest}` ? WithMethod<P, Rest> : never;
}[keyof paths];

/** Questions change nothing of the work, whatever their method; only these may be asked. */
export type Question = Extract<
  Route,
  | `GET ${string}`
  | `${string} /session`
  | "POST /session/link"
  | "POST /audit/verify"
  | "POST /catalogue/import/preview"
  | `POST /recordings/{recording_id}/${"board" | "board/span" | "frames/{n}/contact"}`
  | `POST /recordings/{recording_id}/geometry/${string}`
  | `POST /vehicles/{vehicle_id}/${"frames/{n}/snap" | "follow"}`
  | `POST /scans/{scan_id}/${"line-height" | "line-pose/preview" | "references/preview" | "rig-calibrations/preview"}`
>;

/** What is done: the top bar tells whether it is saved. */
export type Deed = Exclude<Route, Question>;

type OperationOf<R extends Route> = R extends `${infer M} ${infer Rest}`
  ? `/api${Rest}` extends keyof paths
    ? Lowercase<M> extends Method
      ? paths[`/api${Rest}`][Lowercase<M>]
      : never
    : never
  : never;

type Given<O, Where extends "path" | "query"> = O extends { parameters: { [W in Where]?: infer P } }
  ? [NonNullable<P>] extends [never]
    ? unknown
    : NonNullable<P>
  : unknown;

export type ParamsOf<R extends Route> = Given<OperationOf<R>, "path"> & Given<OperationOf<R>, "query">;

/** The query as the address of a page holds it, which anybody may type: names are checked here, values by the server. */
export type AddressOf<R extends Route> = {
  [Name in keyof Given<OperationOf<R>, "query">]?: string | readonly string[];
};

type Content<C> = C extends { "application/json": infer Json }
  ? Json
  : C extends { "multipart/form-data": unknown }
    ? File // the one field `file`
    : never;

/** The JSON that goes out, or the file. */
export type BodyOf<R extends Route> =
  OperationOf<R> extends { requestBody?: infer B }
    ? NonNullable<B> extends { content: infer C }
      ? Content<C>
      : never
    : never;

type Json<A> = A extends { content: { "application/json": infer J } } ? J : undefined;

/** What comes back; undefined where there is nothing to say (204). */
export type AnswerOf<R extends Route> =
  OperationOf<R> extends { responses: infer A } ? Json<A[Extract<keyof A, 200 | 201 | 202 | 204>]> : never;
