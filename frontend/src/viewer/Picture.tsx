/** A picture in its window: a canvas that the caller draws on, an overlay of shapes above it, and the pointer. */
import { useSignalEffect } from "@preact/signals";
import type { ComponentChildren, TargetedPointerEvent } from "preact";
import { useEffect, useLayoutEffect, useMemo, useRef } from "preact/hooks";
import { say } from "../core/messages";
import { type GestureOptions, Gestures } from "./gestures";
import { CursorCross } from "./Overlay";
import { screenPoint } from "./points";
import type { PictureStage } from "./stage";
import type { View } from "./view";
import "./viewer.css";

export interface PictureProps<P, V extends View<P, V>> extends GestureOptions {
  stage: PictureStage<P, V>;
  /** Draws the picture; again when the view or a signal that it reads has changed. */
  draw(canvas: HTMLCanvasElement, view: V): void;
  class: string;
  testId: string;
  label: string;
  /** What it is, in place of "application". */
  what: string;
  describedBy?: string | undefined;
  /** Shapes above the picture, below those of the tools. */
  children?: ComponentChildren;
  /** Plain elements above everything, placed by the caller. */
  above?: ComponentChildren;
  onDblClick?(): void;
}

export function Picture<P, V extends View<P, V>>(props: PictureProps<P, V>) {
  const { stage } = props;
  const host = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const gestures = useMemo(() => new Gestures(stage), [stage]);
  gestures.options = props;
  const latest = useRef(props);
  latest.current = props;
  const space = useSpaceHeld();

  // of the layout, so that a click or a key serves as soon as the picture is seen
  useLayoutEffect(() => (host.current ? stage.attach(host.current) : undefined), [stage]);
  useEffect(() => () => gestures.cancel(), [gestures]);
  useSignalEffect(() => {
    const view = stage.view.value;
    if (canvas.current) latest.current.draw(canvas.current, view);
  });
  useEffect(() => {
    const element = host.current;
    const wheel = (event: WheelEvent): void => {
      event.preventDefault();
      gestures.wheel(placeOf(event), event);
    };
    element?.addEventListener("wheel", wheel, { passive: false });
    return () => element?.removeEventListener("wheel", wheel);
  }, [gestures]);

  const down = (event: TargetedPointerEvent<HTMLDivElement>): void => {
    if (event.pointerType === "touch") {
      event.currentTarget.setPointerCapture(event.pointerId);
      gestures.fingerDown(event.pointerId, placeOf(event));
      return;
    }
    stage.exact = event.shiftKey;
    gestures.down(placeOf(event), event.button, space.current);
    if (gestures.pressed) event.currentTarget.setPointerCapture(event.pointerId);
  };
  const tools = stage.tools.value;
  const cursor = stage.cursor.value;
  return (
    <div
      ref={host}
      class={`${props.class}${stage.placing.value ? ` ${props.class}--placing` : ""}`}
      data-testid={props.testId}
      // biome-ignore lint/a11y/noNoninteractiveTabindex: role "application" takes the keys and clicks itself
      tabIndex={0}
      role="application"
      aria-roledescription={props.what}
      aria-label={props.label}
      aria-describedby={props.describedBy}
      onMouseDown={(event) => event.button === 1 && event.preventDefault()}
      onPointerDown={down}
      onPointerMove={(event) => {
        if (event.pointerType === "touch") {
          gestures.fingerMove(event.pointerId, placeOf(event));
          return;
        }
        gestures.move(placeOf(event));
        event.currentTarget.classList.toggle(`${props.class}--handle`, gestures.overHandle(placeOf(event)));
      }}
      onPointerUp={(event) =>
        event.pointerType === "touch"
          ? gestures.fingerUp(event.pointerId, placeOf(event))
          : gestures.up(placeOf(event))
      }
      onPointerCancel={(event) => {
        gestures.cancel();
        gestures.fingerUp(event.pointerId, placeOf(event));
      }}
      onLostPointerCapture={() => gestures.cancel()}
      onPointerLeave={(event) => event.pointerType !== "touch" && gestures.leave()}
      onDblClick={() => props.onDblClick?.()}
      onContextMenu={(event) => event.preventDefault()}
    >
      <canvas class="filling" ref={canvas} />
      <svg class="filling frame-overlay" aria-hidden="true">
        <title>{say("viewer-layers")}</title>
        {props.children}
        {[...tools].reverse().map((tool) => tool.layers?.())}
        {cursor !== null && (
          <CursorCross at={stage.view.value.toScreen(cursor)} screen={stage.view.value.screen} />
        )}
      </svg>
      {props.above}
      {cursor !== null && stage.keyboard.byFinger.value && (
        <button
          type="button"
          class="btn btn--primary place-here"
          data-testid="place-here"
          onPointerDown={(event) => event.stopPropagation()}
          onClick={() => stage.keyboard.confirm()}
        >
          {say("viewer-place-here")}
        </button>
      )}
    </div>
  );
}

const placeOf = (event: MouseEvent) => screenPoint(event.clientX, event.clientY);

function useSpaceHeld(): { current: boolean } {
  const held = useRef(false);
  useEffect(() => {
    const set = (event: KeyboardEvent): void => {
      if (event.code === "Space") held.current = event.type === "keydown";
    };
    const ends = new AbortController();
    for (const type of ["keydown", "keyup"] as const)
      window.addEventListener(type, set, { capture: true, signal: ends.signal });
    return () => ends.abort();
  }, []);
  return held;
}
