"""What an evidence file says in English, in every other language: the page shows it in that of its reader.

These texts are signed with the rest of the document. Names and what people wrote stay as they are.
"""

from collections.abc import Mapping
from typing import Any

from sightline.enums import JsonObject
from sightline.export.evidence.decision import decision_of, rule_of
from sightline.export.evidence.document import values_of_document, words_of
from sightline.messages import SOURCE, languages, name_of
from sightline.messages.said import Said


def translations_of(document: Mapping[str, Any]) -> JsonObject:
    """By language the sentences of a document by their English, those alone that are said otherwise."""
    return {one: _translate_sentences(document, one) for one in languages()}


def _translate_sentences(document: Mapping[str, Any], language: str) -> JsonObject:
    rule = rule_of(document["decision"])
    values = values_of_document(document["measurement"])
    notes = [Said.read(one) for one in document["scan"]["notes"]]
    english, other = (words_of(notes, values, document["gap"], one) for one in (SOURCE, language))
    translations = {
        document["decision"]["words"]: decision_of(document, rule, language)["words"],
        english["reason"]: other["reason"],
        english["gap"]: other["gap"],
        **dict(zip(english["warnings"], other["warnings"], strict=True)),
        **dict(zip(english["notes"], other["notes"], strict=True)),
    }
    sources = [one["source"] for one in document["measurement"]["budget"]]
    translations |= {text: name_of("budget-of", text, language) for text in sources}
    return {text: said for text, said in translations.items() if text and said != text}
