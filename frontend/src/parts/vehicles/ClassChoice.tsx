/** Which sets and classes of vehicles count: none chosen stands for all. */
import { Checklist, choices } from "../../components";
import { allOf, say } from "../../core/messages";
import type { Category, ClassSet } from "../../core/types";
import { CATEGORY_WORDS, CLASS_SET_WORDS } from "../../core/words";

interface Props {
  classSets: readonly string[];
  categories: readonly string[];
  onClassSets(chosen: string[]): void;
  onCategories(chosen: string[]): void;
}

export function ClassChoice({ classSets, categories, onClassSets, onCategories }: Props) {
  return (
    <Checklist
      label={say("class-choice")}
      words={classWords(classSets, categories) || say("class-choice-any")}
      help={say("class-choice-help")}
      groups={[
        {
          title: say("class-choice-sets"),
          options: choices(CLASS_SET_WORDS),
          chosen: classSets,
          onChange: onClassSets,
        },
        {
          title: say("class-choice-classes"),
          options: choices(CATEGORY_WORDS),
          chosen: categories,
          onChange: onCategories,
        },
      ]}
    />
  );
}

export function classWords(classSets: readonly string[], categories: readonly string[]): string {
  const words = [
    ...classSets.map((one) => CLASS_SET_WORDS[one as ClassSet] ?? one),
    ...categories.map((one) => CATEGORY_WORDS[one as Category] ?? one),
  ];
  return words.length > 0 ? allOf(words) : "";
}
