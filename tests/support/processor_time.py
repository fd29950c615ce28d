"""How many processor seconds the tests of each folder took, against `tests/budget.toml`.

Seconds of the processor and not of the clock. On a slower or busy machine they are more, and so is the
budget: by what a loop takes there after the tests.
"""

import os
import resource
import time
import tomllib
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

BUDGET = Path(__file__).parents[1] / "budget.toml"
#: What `loop_s` is on the machine whose seconds the budget is in.
LOOP_S = 0.04
#: Who is over the budget by more than this share is named.
MARGIN = 0.10
ELSEWHERE = "(collecting)"
CHROMIUM = (
    "browser: without Chromium, whose processes are nobody's children in the end (some four times as much)."
)


def used_s() -> float:
    """What this process, and the children that it has seen the end of, have used."""
    own, ended = resource.getrusage(resource.RUSAGE_SELF), resource.getrusage(resource.RUSAGE_CHILDREN)
    return own.ru_utime + own.ru_stime + ended.ru_utime + ended.ru_stime


def loop_s() -> float:
    """Processor seconds of a loop of two million steps, the best of three."""
    return min(_loop_once_s() for _ in range(3))


def _loop_once_s() -> float:
    begun, steps = time.process_time(), 0
    for _ in range(2_000_000):
        steps = steps + 1
    return time.process_time() - begun


class _Spent:
    """Counts in the process that runs tests, and adds up in the one that tells of them."""

    def __init__(self) -> None:
        self.since = 0.0
        self.seconds: Counter[str] = Counter()
        self.tests: Counter[str] = Counter()
        self.workers_s = 0.0


SPENT = pytest.StashKey[_Spent]()


def pytest_configure(config: pytest.Config) -> None:
    config.stash[SPENT] = spent = _Spent()
    config.pluginmanager.register(_Adding(spent), "processor_time_adding")


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item) -> Any:
    """Set-up, call and teardown each tell what they took; pytest-xdist carries it over."""
    report = yield
    spent, now = item.config.stash[SPENT], used_s()
    report.processor_s, spent.since = now - spent.since, now
    return report


@pytest.hookimpl(trylast=True)
def pytest_sessionfinish(session: pytest.Session) -> None:
    if hasattr(session.config, "workeroutput"):
        session.config.workeroutput["processor_s"] = used_s()


class _Adding:
    """Hooks that are told no configuration."""

    def __init__(self, spent: _Spent) -> None:
        self._spent = spent

    def pytest_runtest_logstart(self) -> None:
        self._spent.since = used_s()

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        parts = report.nodeid.split("::")[0].split("/")
        folder = parts[1] if len(parts) > 2 else "."
        self._spent.seconds[folder] += getattr(report, "processor_s", 0.0)
        self._spent.tests[folder] += report.when == "setup"

    @pytest.hookimpl(optionalhook=True)
    def pytest_testnodedown(self, node: Any) -> None:
        self._spent.workers_s += getattr(node, "workeroutput", {}).get("processor_s", 0.0)


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter, config: pytest.Config) -> None:
    spent = config.stash[SPENT]
    run = "postgresql" if os.environ.get("SIGHTLINE_TEST_DATABASE_URL") else "sqlite"
    slower = slower_than_budgeted(loop_s())
    budget = scaled(tomllib.loads(BUDGET.read_text())[run], slower)
    seconds = dict(spent.seconds.most_common())
    # a controller has seen the end of its workers by now, or has not: they say themselves what they used
    of_all = spent.workers_s or used_s()
    seconds[ELSEWHERE] = of_all - sum(seconds.values())
    terminalreporter.section(f"processor seconds ({run})")
    for folder, took in seconds.items():
        asked = budget.get(folder)
        of = "" if asked is None else f" of {asked:4.0f}"
        terminalreporter.write_line(f"{took:7.1f}{of:8} {spent.tests[folder]:5} {folder}")
    there = f"{of_all / slower:.0f} s of the budget's machine, which is {slower:.2f} times as fast"
    terminalreporter.write_line(f"{of_all:7.1f}{'':8} {spent.tests.total():5} in all: {there}")
    if "browser" in seconds:
        terminalreporter.write_line(CHROMIUM)
    for folder in over(seconds, budget):
        words = f"{folder} took {seconds[folder]:.0f} s, {budget[folder]:.0f} s are its budget here"
        terminalreporter.write_line(f"WARNING: {words} ({slower:.2f} x)", yellow=True)


def slower_than_budgeted(loop: float) -> float:
    """How many times as long work takes here as on the budget's machine, by what `loop_s` says; 1 or more."""
    return max(1.0, loop / LOOP_S)


def scaled(budget: dict[str, float], slower: float) -> dict[str, float]:
    """The budget where work takes so many times as long."""
    return {folder: seconds * slower for folder, seconds in budget.items()}


def over(seconds: dict[str, float], budget: dict[str, float]) -> list[str]:
    """The folders that took more than their budget and its margin."""
    return [name for name, took in seconds.items() if took > (1 + MARGIN) * budget.get(name, float("inf"))]
