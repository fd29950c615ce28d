// The types of the catalogue: each message's key, the values that it takes and the parts that it marks, out of en.ftl.
import { readFileSync, writeFileSync } from "node:fs";
import { FluentParser, Visitor } from "@fluent/syntax";

const SOURCE = new URL("../../backend/sightline/messages/en.ftl", import.meta.url);
const TARGET = new URL("../../.build/messages.d.ts", import.meta.url);
const USUAL = new Set(["strong", "em", "kbd", "code", "sub"]);

class Facts extends Visitor {
  values = new Map();
  parts = new Set();

  /** A number where it is formatted or counted as one, else a number or a text. */
  visitVariableReference(node) {
    if (!this.values.has(node.id.name)) this.values.set(node.id.name, "string | number");
  }
  visitFunctionReference(node) {
    for (const one of node.arguments.positional) {
      if (one.type === "VariableReference") this.values.set(one.id.name, "number");
    }
    this.genericVisit(node);
  }
  visitSelectExpression(node) {
    const plural = node.variants.every(({ key }) => key.type === "NumberLiteral" || PLURALS.has(key.name));
    const words = node.variants.map(({ key }) => JSON.stringify(key.name ?? key.value)).join(" | ");
    if (node.selector.type === "VariableReference") this.values.set(node.selector.id.name, plural ? "number" : words);
    this.genericVisit(node);
  }
  visitTextElement(node) {
    for (const [, name] of node.value.matchAll(/<([a-z][a-z0-9]*)>/g)) if (!USUAL.has(name)) this.parts.add(name);
  }
}

const PLURALS = new Set(["zero", "one", "two", "few", "many", "other"]);

const resource = new FluentParser().parse(readFileSync(SOURCE, "utf8"));
const known = new Set();
const values = [];
const parts = [];
for (const entry of resource.body) {
  if (entry.type === "Junk") {
    console.error(`en.ftl: this is no message:\n${entry.content}`);
    process.exit(1);
  }
  if (entry.type !== "Message" || !entry.value) continue;
  if (known.has(entry.id.name)) {
    console.error(`en.ftl: ${entry.id.name} stands there twice`);
    process.exit(1);
  }
  known.add(entry.id.name);
  const facts = new Facts();
  facts.visit(entry.value);
  const fields = [...facts.values].map(([name, type]) => `${name}: ${type}`).join("; ");
  values.push(`  "${entry.id.name}": ${fields ? `{ ${fields} }` : null};`);
  if (facts.parts.size > 0) parts.push(`  "${entry.id.name}": ${[...facts.parts].map((p) => `"${p}"`).join(" | ")};`);
}
const text = `/** Made by tools/messages.mjs out of en.ftl. */
export interface Messages {
${values.join("\n")}
}
export interface Parts {
${parts.join("\n")}
}
`;
writeFileSync(TARGET, text);
