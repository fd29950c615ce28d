/**
 * Text that is being typed and not yet told. While a field is in use, news from the server must neither overwrite it nor
 * become the version it is compared with: whoever typed first on an old version is asked, not overruled.
 */
import { createContext } from "preact";
import { useContext, useEffect, useRef, useState } from "preact/hooks";

export interface Hold {
  /** The first letter is typed. */
  start(): void;
  /** The field is left. */
  end(): void;
}

export const TypingHold = createContext<Hold | null>(null);

export interface Typing {
  readonly text: string;
  /** Something is typed and not yet told. */
  open(): boolean;
  type(text: string): void;
  /** The field is left or Enter pressed: answers the trimmed text if it differs from the value, else null. */
  finish(): string | null;
  /** Back to the value. */
  undo(): void;
}

export function useTyping(value: string): Typing {
  const [text, setText] = useState(value);
  const started = useRef<string | null>(null);
  const hold = useContext(TypingHold);
  useEffect(() => {
    if (started.current === null) setText(value);
  }, [value]);
  const stop = (): void => {
    started.current = null;
    hold?.end();
  };
  return {
    text,
    open: () => started.current !== null,
    type(typed) {
      if (started.current === null) {
        started.current = value;
        hold?.start();
      }
      setText(typed);
    },
    finish() {
      const before = started.current;
      if (before === null) return null;
      const changed = text.trim() !== before;
      if (!changed) setText(value);
      started.current = null;
      return changed ? text.trim() : null;
    },
    undo() {
      setText(value);
      stop();
    },
  };
}
