"""What a proxy says of a caller is believed where the settings name the proxy, and nowhere else."""

from pathlib import Path

import pytest
from fastapi import FastAPI, Request
from fastapi.testclient import TestClient

from sightline.commands.serve import web_config
from sightline.infra.web.deps import address_of
from sightline.settings import Settings


@pytest.mark.parametrize(
    ("proxies", "address"),
    [
        ("", "127.0.0.1"),
        ("10.0.0.7", "127.0.0.1"),
        ("127.0.0.1", "198.51.100.9"),
        ("127.0.0.0/8, 10.0.0.7", "198.51.100.9"),
        ("*", "198.51.100.9"),
    ],
)
def test_who_is_believed(tmp_path: Path, proxies: str, address: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("FORWARDED_ALLOW_IPS", "*")  # the web server's own; ours alone counts
    app = FastAPI()

    @app.get("/")
    def caller(request: Request) -> str:
        return address_of(request)

    config = web_config(app, Settings(data_dir=tmp_path, proxies=proxies))
    config.load()
    client = TestClient(config.loaded_app, client=("127.0.0.1", 5000))
    assert client.get("/", headers={"X-Forwarded-For": "198.51.100.9"}).json() == address
