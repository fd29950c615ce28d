"""The networks that propose points, in PyTorch: how they are built, trained and written as ONNX.

Nothing of the application imports this file, and PyTorch is none of its packages.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import torch
from torch import nn
from torch.nn import functional as F

SEED = 20261124
BATCH = 32
RATE = 2e-3
COARSE_ROUNDS, FINE_ROUNDS = 8, 5
NEAR = 1.0  # cells of the maps: how wide a place is drawn
EXACT_ROUNDS = 1  # the last ones, in single precision; those before in half
KEPT_BACK = 7  # every so many sites are looked at only


def _step(n_in: int, n_out: int, stride: int = 1) -> nn.Sequential:
    return nn.Sequential(nn.Conv2d(n_in, n_out, 3, stride, 1, bias=False), nn.BatchNorm2d(n_out), nn.ReLU())


class Coarse(nn.Module):  # type: ignore[misc]
    """(n, 4, 60, 144) -> maps (n, 6, 30, 72): logits of the cells against "not seen", which is 0."""

    def __init__(self) -> None:
        super().__init__()
        self.a = nn.Sequential(_step(4, 12, 2), _step(12, 16))
        self.b = nn.Sequential(_step(16, 24, 2), _step(24, 24))
        self.c = nn.Sequential(_step(24, 40, 2), _step(40, 40), _step(40, 40))
        self.d = nn.Sequential(_step(40, 48, 2), _step(48, 48), _step(48, 48))
        self.e, self.f, self.g = _step(48 + 40, 40), _step(40 + 24, 24), _step(24 + 16, 24)
        self.out = nn.Conv2d(24, 6, 1)

    def forward(self, x: torch.Tensor) -> torch.Tensor:
        a = self.a(x)
        b = self.b(a)
        c = self.c(b)
        y = _up(self.d(c), c)
        y = _up(self.e(y), b)
        return self.out(self.g(_up(self.f(y), a)))


def _up(low: torch.Tensor, beside: torch.Tensor) -> torch.Tensor:
    size = (int(beside.shape[2]), int(beside.shape[3]))
    return torch.cat([F.interpolate(low, size=size, mode="nearest"), beside], 1)


class Fine(nn.Module):  # type: ignore[misc]
    """(n, 4, 48, 48) -> maps (n, 4, 24, 24): logits of the cells; stats (n, 12): of each point the logarithm
    of its standard error along and up, cells, and the logit of being seen.
    """

    def __init__(self) -> None:
        super().__init__()
        self.a = nn.Sequential(_step(4, 16, 2), _step(16, 24), _step(24, 24))
        self.b = nn.Sequential(_step(24, 32, 2), _step(32, 32))
        self.c = nn.Sequential(_step(32, 48, 2), _step(48, 48))
        self.d, self.e = _step(48 + 32, 32), _step(32 + 24, 24)
        self.out = nn.Conv2d(24, 4, 1)
        self.stats = nn.Sequential(nn.Flatten(), nn.Linear(48 * 36, 32), nn.ReLU(), nn.Linear(32, 12))

    def forward(self, x: torch.Tensor) -> tuple[torch.Tensor, torch.Tensor]:
        a = self.a(x)
        b = self.b(a)
        c = self.c(b)
        return self.out(self.e(_up(self.d(_up(c, b)), a))), self.stats(c)


def trained(which: str, data: Any, coarse_step: int, fine_step: int, folder: Path) -> None:
    """One of both networks ("coarse", "fine"), from what `train_proposals lay` made, written to `folder`."""
    torch.manual_seed(SEED)
    if which == "coarse":
        places = torch.from_numpy(_stepped(data["places"], coarse_step))
        net = _fit(Coarse(), data["coarse"], data["coarse_seed"], COARSE_ROUNDS, _coarse_loss, places)
        _written(net, torch.zeros(1, *data["coarse"].shape[1:]), ["maps"], folder / "coarse.onnx")
        return
    place = torch.from_numpy(_stepped(data["place"], fine_step))
    kind = torch.from_numpy(data["kind"])
    net = _fit(Fine(), data["fine"], data["fine_seed"], FINE_ROUNDS, _fine_loss, place, kind)
    _written(net, torch.zeros(1, *data["fine"].shape[1:]), ["maps", "stats"], folder / "fine.onnx")


def _stepped(cells: Any, step: int) -> Any:
    """Cells of the picture as cells of the maps."""
    return ((cells - (step - 1) / 2) / step).astype(np.float32)


def _fit(net: Any, views: Any, seeds: Any, rounds: int, loss_of: Any, *truth: torch.Tensor) -> Any:
    kept = seeds % KEPT_BACK == 0
    train, held = np.flatnonzero(~kept), np.flatnonzero(kept)
    rng = np.random.default_rng(SEED)
    net = net.to(memory_format=torch.channels_last)
    way = torch.optim.AdamW(net.parameters(), RATE, weight_decay=1e-3)
    steps = rounds * (len(train) // BATCH)
    pace = torch.optim.lr_scheduler.OneCycleLR(way, RATE, total_steps=max(steps, 1), pct_start=0.1)
    for number in range(rounds):
        net.train()
        order, total = rng.permutation(train), 0.0
        for i in range(0, len(order) - BATCH + 1, BATCH):
            some = np.sort(order[i : i + BATCH])
            with torch.autocast("cpu", torch.bfloat16, enabled=number < rounds - EXACT_ROUNDS):
                out = net(_varied(views[some], rng).to(memory_format=torch.channels_last))
            loss, _ = loss_of(_floats(out), *(one[some] for one in truth))
            way.zero_grad()
            loss.backward()
            nn.utils.clip_grad_norm_(net.parameters(), 5.0)
            way.step()
            pace.step()
            total += float(loss.detach())
        print(
            number, f"{total * BATCH / len(order):.3f}", _told(net, views, held, loss_of, truth), flush=True
        )
    return net.eval().to(memory_format=torch.contiguous_format)


def _floats(out: Any) -> Any:
    return out.float() if torch.is_tensor(out) else tuple(one.float() for one in out)


def _varied(views: Any, rng: np.random.Generator) -> torch.Tensor:
    """Colour, contrast, noise and the weight of the change differ from view to view."""
    x = torch.from_numpy(views.astype(np.float32))
    n = len(x)
    gain = torch.from_numpy(rng.uniform(0.75, 1.3, (n, 3, 1, 1)).astype(np.float32))
    shift = torch.from_numpy(rng.normal(0, 0.12, (n, 3, 1, 1)).astype(np.float32))
    seen = x[:, 3:] >= 0
    x[:, :3] = (x[:, :3] * gain + shift + 0.05 * torch.randn_like(x[:, :3])) * seen
    clear = torch.from_numpy((rng.uniform(size=(n, 1, 1, 1)) < 0.9).astype(np.float32))
    x[:, 3:] = torch.where(seen, x[:, 3:] * clear, x[:, 3:])
    return x


def _told(net: Any, views: Any, held: Any, loss_of: Any, truth: Any) -> str:
    net.eval()
    losses, told = [], []
    with torch.no_grad():
        for i in range(0, len(held), 256):
            some = held[i : i + 256]
            out = net(torch.from_numpy(views[some].astype(np.float32)))
            loss, errors = loss_of(out, *(one[some] for one in truth))
            losses.append(float(loss))
            told.append(errors)
    if not told:
        return ""
    every = np.concatenate(told)
    words = [f"{np.mean(losses):.3f}"]
    for k in np.unique(every[:, 0]):
        mine = every[every[:, 0] == k]
        words.append(f"{int(k)}: {np.sqrt(np.mean(mine[:, 1] ** 2)):.2f} {np.median(np.abs(mine[:, 1])):.2f}")
    return "; ".join(words)


def _drawn(place: torch.Tensor, rows: int, columns: int) -> torch.Tensor:
    """A small hill (n, rows, columns), sum 1, about places (n, 2): column, row."""
    r = torch.arange(rows, dtype=torch.float32)[None, :, None]
    c = torch.arange(columns, dtype=torch.float32)[None, None, :]
    apart = (c - place[:, 0, None, None]) ** 2 + (r - place[:, 1, None, None]) ** 2
    hill = torch.exp(-0.5 * apart / NEAR**2)
    return hill / hill.sum((1, 2), keepdim=True).clamp_min(1e-9)


def _coarse_loss(maps: torch.Tensor, places: torch.Tensor) -> tuple[torch.Tensor, Any]:
    n, k, rows, columns = maps.shape
    seen = torch.isfinite(places).all(-1).reshape(-1)
    at = torch.nan_to_num(places).reshape(-1, 2)
    logits = torch.cat([maps.reshape(n * k, -1), torch.zeros(n * k, 1)], 1)
    target = torch.cat(
        [_drawn(at, rows, columns).reshape(n * k, -1) * seen[:, None], (~seen).float()[:, None]], 1
    )
    loss = -(target * F.log_softmax(logits, 1)).sum(1).mean()
    best = maps.reshape(n * k, -1).argmax(1)
    off = torch.hypot(best % columns - at[:, 0], best // columns - at[:, 1]).detach()
    which = torch.arange(k).repeat(n)
    return loss, torch.stack([which.float(), off.clamp(max=9)], 1)[seen].numpy()


def _fine_loss(out: Any, place: torch.Tensor, kind: torch.Tensor) -> tuple[torch.Tensor, Any]:
    maps, stats = out
    n, _, rows, columns = maps.shape
    every = torch.arange(n)
    mine, said = maps[every, kind].reshape(n, -1), stats.reshape(n, 4, 3)[every, kind]
    seen = torch.isfinite(place).all(-1)
    weights = F.softmax(mine, 1).reshape(n, rows, columns)
    at = torch.stack(
        [weights.sum(1) @ torch.arange(columns).float(), weights.sum(2) @ torch.arange(rows).float()], 1
    )
    off = at - torch.nan_to_num(place)
    log_u = said[:, :2].clamp(-4, 4) - np.log(2.0)  # said in cells of the picture
    nll = (0.5 * (off * torch.exp(-log_u)) ** 2).clamp(max=60) + log_u
    nll = (nll * torch.tensor([0.5, 1.0])).sum(1)
    hill = -(_drawn(torch.nan_to_num(place), rows, columns).reshape(n, -1) * F.log_softmax(mine, 1)).sum(1)
    sure = F.binary_cross_entropy_with_logits(said[:, 2], seen.float())
    loss = ((nll + 0.3 * hill) * seen).sum() / seen.sum().clamp_min(1) + sure
    return loss, torch.stack([kind.float(), off[:, 1]], 1)[seen].detach().numpy()


def _written(net: Any, like: torch.Tensor, outputs: list[str], path: Path) -> None:
    torch.onnx.export(
        net.eval(),
        (like,),
        str(path),
        input_names=["view"],
        output_names=outputs,
        dynamic_axes={name: {0: "n"} for name in ["view", *outputs]},
        opset_version=13,
        dynamo=False,
    )
