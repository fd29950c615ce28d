import { describe, expect, it } from "vitest";
import { ofZip } from "./pieces";

// By Python's zipfile: top/audit.csv (deflated, "packed " thirty times) and top/crops/é.bin (stored, bytes 0 to 19).
const PLAIN = [
  "UEsDBBQAAAAIAAAAIQDT6uKnDAAAANIAAAANAAAAdG9wL2F1ZGl0LmNzditITM5OTVEoGD4UAFBLAwQUAAAIAAAAACEApP/dOxQAAAAU",
  "AAAAEAAAAHRvcC9jcm9wcy/DqS5iaW4AAQIDBAUGBwgJCgsMDQ4PEBESE1BLAQIUAxQAAAAIAAAAIQDT6uKnDAAAANIAAAANAAAAAAAA",
  "AAAAAACAAQAAAAB0b3AvYXVkaXQuY3N2UEsBAhQDFAAACAAAAAAhAKT/3TsUAAAAFAAAABAAAAAAAAAAAAAAAIABNwAAAHRvcC9jcm9w",
  "cy/DqS5iaW5QSwUGAAAAAAIAAgB5AAAAeQAAAAAA",
].join("");
// The same as a ZIP of more than 4 GB would be: sizes and places in 64 bits.
const LARGE = [
  "UEsDBC0AAAAIAAAAIQDT6uKn//////////8NABQAdG9wL2F1ZGl0LmNzdgEAEADSAAAAAAAAAAwAAAAAAAAAK0hMzk5NUSgYPhQAUEsD",
  "BC0AAAgAAAAAIQCk/907//////////8QABQAdG9wL2Nyb3BzL8OpLmJpbgEAEAAUAAAAAAAAABQAAAAAAAAAAAECAwQFBgcICQoLDA0O",
  "DxAREhNQSwECLQMtAAAACAAAACEA0+rip///////////DQAUAAAAAAAAAAAAgAEAAAAAdG9wL2F1ZGl0LmNzdgEAEADSAAAAAAAAAAwA",
  "AAAAAAAAUEsBAi0DLQAACAAAAAAhAKT/3Tv//////////xAAHAAAAAAAAAAAAIAB/////3RvcC9jcm9wcy/DqS5iaW4BABgAFAAAAAAA",
  "AAAUAAAAAAAAAEsAAAAAAAAAUEsGBiwAAAAAAAAALQAtAAAAAAAAAAAAAgAAAAAAAAACAAAAAAAAAKkAAAAAAAAAoQAAAAAAAABQSwYH",
  "AAAAAEoBAAAAAAAAAQAAAFBLBQYAAAAAAgACAKkAAAChAAAAAAA=",
].join("");

const bytesOf = (text: string) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
const zipOf = (bytes: Uint8Array<ArrayBuffer>) => new Blob([bytes]);

describe("the files of a ZIP", () => {
  it.each([
    ["plain", PLAIN],
    ["of 64 bits", LARGE],
  ])("are read, %s, without the folder around them", async (_, text) => {
    const found = await ofZip(zipOf(bytesOf(text)));
    expect(found.map((one) => [one.path, one.size])).toEqual([
      ["audit.csv", 210],
      ["crops/é.bin", 20],
    ]);
    const [audit, crop] = await Promise.all(found.map((one) => one.bytes()));
    expect(new TextDecoder().decode(audit)).toBe("packed ".repeat(30));
    expect([...(crop ?? [])]).toEqual([...Array(20).keys()]);
  });

  it("are refused where the ZIP is cut off, wherever", async () => {
    const whole = bytesOf(PLAIN);
    for (let bytes = 0; bytes < whole.length; bytes += 7)
      await expect(ofZip(zipOf(whole.slice(0, bytes)))).rejects.toThrow();
  });

  it("are refused where a file unpacks to more, or to less, than was told", async () => {
    for (const told of [1, 209, 211]) {
      const spoiled = bytesOf(PLAIN);
      const view = new DataView(spoiled.buffer);
      const central = spoiled.findIndex(
        (_, at) => at < spoiled.length - 4 && view.getUint32(at, true) === 0x02014b50,
      );
      view.setUint32(central + 24, told, true);
      const [audit] = await ofZip(zipOf(spoiled));
      await expect(audit?.bytes()).rejects.toThrow();
    }
  });
});
