"""Sentences of answers in the language that the request asks for.

The rooms below and what is stored say codes; here, at the edge, what is read is said in the first language of
`Accept-Language` that there is: a `message` by the code beside it, and in its values what a thing is called
(`messages.recognised`). Names and notes of people are not looked at, nor are documents (a pose, a package, a
signed page), which are the same for everybody. Who asks for no language gets what is stored.
"""

import json
from typing import Any

from starlette.datastructures import Headers, MutableHeaders
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from sightline import messages
from sightline.messages.recognised import translate_text

_API = "/api/"


class Spoken:
    def __init__(self, app: ASGIApp) -> None:
        self.app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        language = language_of(scope) if scope["type"] == "http" else messages.SOURCE
        if language == messages.SOURCE:
            await self.app(scope, receive, send)
            return
        await self.app(scope, receive, _Translating(send, language))


class _Translating:
    """Holds an answer in JSON back until it is whole; others go through as they come."""

    def __init__(self, send: Send, language: str) -> None:
        self._send, self._language = send, language
        self._start: Message | None = None
        self._body = b""

    async def __call__(self, message: Message) -> None:
        if message["type"] == "http.response.start" and _is_answer(Headers(raw=message["headers"])):
            self._start = message
        elif self._start is None:
            await self._send(message)
        else:
            self._body += message.get("body", b"")
            if not message.get("more_body", False):
                await self._tell(self._start)

    async def _tell(self, start: Message) -> None:
        body = translate_body(self._body, self._language)
        headers = MutableHeaders(scope=start)
        headers["Content-Length"] = str(len(body))
        headers["Content-Language"] = self._language
        headers.add_vary_header("Accept-Language")
        await self._send(start)
        await self._send({"type": "http.response.body", "body": body})


def language_of(scope: Scope) -> str:
    """The first language of the request that there is, by weight; English for documents and other paths."""
    if not scope["path"].startswith(_API) or scope["path"].endswith(".json"):
        return messages.SOURCE
    wishes = Headers(scope=scope).get("accept-language", "")[:200].split(",")
    for _, wish in sorted(((-_weight(one), one.split(";")[0].strip()) for one in wishes), key=lambda w: w[0]):
        for name in (wish, wish.split("-")[0]):
            if name in messages.languages():
                return name
    return messages.SOURCE


def _weight(wish: str) -> float:
    try:
        return float(wish.partition(";q=")[2] or 1)
    except ValueError:
        return 0.0


def _is_answer(headers: Headers) -> bool:
    return headers.get("content-type") == "application/json" and "content-disposition" not in headers


def translate_body(body: bytes, language: str) -> bytes:
    """JSON with its sentences in a language."""
    if not body:
        return body
    said = _walked(json.loads(body), language)
    return json.dumps(said, ensure_ascii=False, separators=(",", ":")).encode()


def _walked(value: Any, language: str, *, of_code: bool = False) -> Any:
    """of_code: it is among the values of a code."""
    if isinstance(value, str):
        return translate_text(value, language) if of_code else value
    if isinstance(value, list):
        return [_walked(one, language, of_code=of_code) for one in value]
    if isinstance(value, dict):
        walked = {
            key: _walked(one, language, of_code=of_code or key == "values") for key, one in value.items()
        }
        if value.keys() >= {"code", "values", "message"}:
            walked["message"] = said_by_key(value, value["message"], language)
        return walked
    return value


def said_by_key(said: dict[str, Any], english: str, language: str) -> str:
    """The sentence of a key; the English where this program has no such key, as an older one's."""
    values = {name: _value(one, language) for name, one in said["values"].items()}
    try:
        return messages.say(said["code"], values, language)
    except (KeyError, ValueError):
        return english


def _value(given: Any, language: str) -> str | float:
    """A value that is a sentence of the program is said too."""
    if isinstance(given, dict):
        return said_by_key(given, str(given.get("message", given["code"])), language)
    value: str | float = translate_text(given, language) if isinstance(given, str) else given
    return value
