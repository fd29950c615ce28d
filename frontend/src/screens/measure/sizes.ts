/** The sizes of a model in words, and how a vehicle's model was chosen. */
import { allOf, wordsOf } from "../../core/messages";
import type { ModelChosenBy, ModelSize } from "../../core/types";

export const SIZE_WORDS: Readonly<Record<ModelSize, string>> = wordsOf("which-model-size-");

export const CHOSEN_BY_WORDS: Readonly<Record<ModelChosenBy, string>> = wordsOf("model-chosen-word-");

/** "roof and wheelbase", of the words that a record keeps. */
export function sizesWords(sizes: string): string {
  return allOf(sizes.split(" ").map((size) => SIZE_WORDS[size as ModelSize] ?? size));
}
