/**
 * Text that is being typed and not yet told. While a field is in use, news from the server must neither overwrite it nor
 * become the version it is compared with: whoever typed first on an old version is asked, not overruled.
 */
import { createContext } from "preact";
import { useContext, useEffect, useRef, useState } from "preact/hooks";

export interface Hold {
  start(): void;
  end(): void;
}

export const TypingHold = createContext<Hold | null>(null);

/** `usual` is the text that an emptied field stands for. */
export function useTyping(value: string, usual = "") {
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
  /** What it would be told as. */
  const told = (): string => text.trim() || usual;
  return {
    text,
    told,
    /** Something is typed and not yet told. */
    open: () => started.current !== null,
    type(typed: string) {
      if (started.current === null) {
        started.current = value;
        hold?.start();
      }
      setText(typed);
    },
    /** The field is left or Enter pressed: answers what is told if it differs from the value, else null. */
    finish() {
      const before = started.current;
      if (before === null) return null;
      const now = told();
      const changed = now !== before;
      if (!changed) setText(value);
      started.current = null;
      return changed ? now : null;
    },
    undo() {
      setText(value);
      stop();
    },
  };
}
