// Finds what a person reads and that is not in the catalogue of messages: text between tags, attributes that are
// shown, and strings that read like words. `node tools/sentences.mjs` prints file, line and text, and fails;
// `node tools/sentences.mjs src/screens/x` looks only there.
import { readdirSync, readFileSync } from "node:fs";
import { join, relative } from "node:path";
import { fileURLToPath } from "node:url";
import ts from "typescript";

const ROOT = fileURLToPath(new URL("..", import.meta.url));
const SHOWN = new Set(["title", "label", "placeholder", "alt", "hint", "help", "note", "word", "words", "head", "unit"]);
const HIDDEN = new Set(["class", "scroll", "id", "role", "type", "name", "href", "key", "rel", "target", "autocomplete", "style", "preserveAspectRatio"]);
const KEYS = /^(Enter|Escape|Tab|Space|Delete|Backspace|Home|End|Page(Up|Down)|Arrow(Left|Right|Up|Down)|Del|Esc|Shift|Alt|Ctrl|Control|Meta|F\d+)$/;
// Names of browsers' errors and of headers, which are compared and never shown.
const NAMES = /^([A-Z][a-z]+(Error|Exception)|Content-[A-Z][a-z]+|If-Match|Retry-After)$/;

/** Whether a string reads like words for a person. */
function readsLikeWords(text) {
  if (KEYS.test(text) || NAMES.test(text) || /^(GET|POST|PUT|PATCH|DELETE) \//.test(text)) return false;
  if (/--|__|^\(prefers-|\bvar\(|^[.#[]|[{}=]|;(?! \p{L})|=>|url\(|^M\d|\d(px|fr|em)\b/u.test(text)) return false;
  return /\p{L}{2,}[,;:]? \p{L}+/u.test(text) || /\p{L}{2,}[.…?!]$/u.test(text) || /^\p{Lu}\p{Ll}{2,}$/u.test(text);
}

function filesOf(folder) {
  return readdirSync(folder, { withFileTypes: true }).flatMap((one) => {
    const path = join(folder, one.name);
    if (one.isDirectory()) return filesOf(path);
    return /\.tsx?$/.test(one.name) && !/\.test\.tsx?$/.test(one.name) ? [path] : [];
  });
}

/** Whether a string stands where nobody reads it: types, imports, names, comparisons, errors for developers. */
function isNoText(node) {
  let { parent } = node;
  while (ts.isConditionalExpression(parent) || ts.isParenthesizedExpression(parent)) ({ parent } = parent);
  if (ts.isLiteralTypeNode(parent) || ts.isImportDeclaration(parent) || ts.isExportDeclaration(parent)) return true;
  if (ts.isExternalModuleReference(parent) || ts.isElementAccessExpression(parent) || ts.isCaseClause(parent)) return true;
  if (ts.isPropertyAssignment(parent) && parent.name === node) return true;
  if (ts.isBinaryExpression(parent) && /^[!=]==?$/.test(parent.operatorToken.getText())) return true;
  if (ts.isNewExpression(parent) && /(?<!^Api)(Error|Exception)$|^Intl|^URL|^RegExp/.test(parent.expression.getText())) return true;
  if (ts.isCallExpression(parent)) {
    const called = parent.expression.getText();
    return /^(say|sentence|hint|commandName|console\.\w+|api\.\w+|.*(addEventListener|querySelector(All)?|closest|matches|includes|startsWith|endsWith|split|join|replace(All)?|test|has|get|getElementById|createElement|stored|import))$/.test(called);
  }
  return false;
}

function attributeOf(node) {
  for (let at = node.parent; at; at = at.parent) {
    if (ts.isJsxAttribute(at)) return at.name.getText();
    if (ts.isArrowFunction(at) || ts.isJsxElement(at) || ts.isJsxSelfClosingElement(at)) return null;
  }
  return null;
}

function hidden(attribute) {
  return attribute !== null && (HIDDEN.has(attribute) || /^(data|on)[-A-Z]/.test(attribute) || attribute === "what");
}

function found(path) {
  const source = ts.createSourceFile(path, readFileSync(path, "utf8"), ts.ScriptTarget.Latest, true, ts.ScriptKind.TSX);
  const hits = [];
  const tell = (node, text) => {
    const { line } = source.getLineAndCharacterOfPosition(node.getStart());
    hits.push(`${relative(ROOT, path)}:${line + 1}: ${text.trim().replace(/\s+/g, " ").slice(0, 90)}`);
  };
  const visit = (node) => {
    if (ts.isJsxText(node) && /\p{L}{2,}/u.test(node.text)) tell(node, node.text);
    const text = ts.isTemplateExpression(node)
      ? [node.head.text, ...node.templateSpans.map((one) => one.literal.text)].join("{}").replaceAll("{}", "0")
      : ts.isStringLiteralLike(node)
        ? node.text
        : null;
    if (text !== null && !isNoText(node)) {
      const attribute = attributeOf(node);
      const shown = attribute !== null && (SHOWN.has(attribute) || attribute === "aria-label" || attribute === "aria-description");
      const letters = /\p{L}{2,}/u.test(text);
      if (!hidden(attribute) && ((shown && letters) || readsLikeWords(text))) tell(node, text);
    }
    ts.forEachChild(node, visit);
  };
  visit(source);
  return hits;
}

const named = process.argv.slice(2);
const files = filesOf(join(ROOT, "src"));
const under = (path, folder) => relative(ROOT, path).startsWith(folder);
const wanted = named.length > 0 ? files.filter((path) => named.some((folder) => under(path, folder))) : files;
const problems = wanted.flatMap(found);
if (problems.length > 0) {
  console.error(`${problems.join("\n")}\n${problems.length} sentences outside backend/sightline/messages/en.ftl`);
  process.exit(1);
}
