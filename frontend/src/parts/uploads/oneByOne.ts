/** Files sent one after the other: how many are still to go, and what was said of those that were refused. */
import { useState } from "preact/hooks";
import { explain } from "../../core/api";

export function useOneByOne(send: (file: File) => Promise<void>) {
  const [waiting, setWaiting] = useState(0);
  const [refused, setRefused] = useState<readonly { name: string; problem: string }[]>([]);
  const add = async (files: readonly File[]) => {
    setRefused([]);
    for (const [at, file] of files.entries()) {
      setWaiting(files.length - at);
      await send(file).catch((error: unknown) =>
        setRefused((before) => [...before, { name: file.name, problem: explain(error) }]),
      );
    }
    setWaiting(0);
  };
  return { waiting, refused, add };
}
