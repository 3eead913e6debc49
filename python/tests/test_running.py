"""While a map is computed: progress, interruption, threads, memory."""

from __future__ import annotations

import os
import signal
import threading
import time
from typing import Any, List

import numpy as np
import pytest

import hgp


def test_progress_reports_stages_in_order(pretzel: Any) -> None:
    reports: List[hgp.Progress] = []
    hgp.parametrize(*pretzel, improve="isometric", progress=reports.append)
    stages = list(dict.fromkeys(report.stage for report in reports))
    assert stages[0] == "prepare" and stages[-1] == "improve" and "solve" in stages
    assert all(0 <= report.fraction <= 1 for report in reports)
    assert [r.seconds for r in reports] == sorted(r.seconds for r in reports)


def test_an_exception_of_the_callback_arrives_unchanged(pretzel: Any) -> None:
    class Odd(Exception):
        pass

    def fail(report: hgp.Progress) -> None:
        raise Odd(report.stage)

    with pytest.raises(Odd, match="prepare"):
        hgp.parametrize(*pretzel, progress=fail)


def test_ctrl_c_interrupts(pretzel: Any) -> None:
    V, F = pretzel
    many = np.vstack([V + [3.0 * i, 0, 0] for i in range(40)])
    F = np.vstack([F + i * len(V) for i in range(40)])
    timer = threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT))
    begin = time.thread_time()
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        hgp.parametrize(many, F, improve="isometric")
    used = time.thread_time() - begin
    whole = 40 * _seconds(lambda: hgp.parametrize(*pretzel, improve="isometric"))
    assert used < whole / 2


def _seconds(call: Any) -> float:
    begin = time.thread_time()
    call()
    return time.thread_time() - begin


def test_other_threads_run_meanwhile_and_results_are_equal(pretzel: Any) -> None:
    counts: List[int] = []
    isDone = threading.Event()

    def count() -> None:
        n = 0
        while not isDone.is_set():
            n += 1
            time.sleep(0.001)
        counts.append(n)

    counter = threading.Thread(target=count)
    counter.start()
    maps: List[hgp.Map] = []
    mesh = hgp.Mesh(*pretzel)  # shared: its calls follow one another
    calls = [lambda: hgp.parametrize(*pretzel), lambda: hgp.parametrize(*pretzel), mesh.parametrize, mesh.parametrize]
    threads = [threading.Thread(target=lambda call=call: maps.append(call())) for call in calls]  # type: ignore[misc]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    isDone.set()
    counter.join()
    assert len(maps) == 4 and all((m.uv == maps[0].uv).all() for m in maps)
    assert counts[0] > 3


def test_reproducible_calls_are_so_among_others(pretzel: Any) -> None:
    alone = [hgp.parametrize(*pretzel, reproducible=asked).uv for asked in (False, True)]
    for _ in range(3):
        found: List[Any] = [None, None]

        def run(asked: bool) -> None:
            found[asked] = hgp.parametrize(*pretzel, reproducible=asked).uv

        threads = [threading.Thread(target=run, args=(asked,)) for asked in (False, True)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert all((a == b).all() for a, b in zip(found, alone))


def test_the_number_of_threads_changes_nothing(pretzel: Any) -> None:
    def run(threads: Any) -> Any:
        hgp.set_threads(threads)
        m = hgp.parametrize(*pretzel, improve="isometric")
        return m.uv.tobytes(), m.fuv.tobytes()

    try:
        assert run(1) == run(4) == run(None)
        for wrong in (0, 17, -1, True, 2.0):
            with pytest.raises(hgp.UsageError, match="threads must be from 1 to 16"):
                hgp.set_threads(wrong)  # type: ignore[arg-type]
    finally:
        hgp.set_threads()


def test_a_progress_function_that_would_wait_for_itself_is_refused(cube: Any, square: Any) -> None:
    mesh = hgp.Mesh(*cube)
    with pytest.raises(hgp.UsageError, match="cannot call the mesh"):
        mesh.parametrize(progress=lambda p: mesh.inspect())
    with pytest.raises(hgp.UsageError, match="inside a progress function"):
        mesh.parametrize(progress=lambda p: hgp.parametrize(*square, reproducible=True))
    assert mesh.parametrize(progress=lambda p: hgp.parametrize(*square).certified).certified


def _resident() -> int:
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def test_memory_is_flat_over_a_thousand_calls(cube: Any) -> None:
    V, F = cube

    def call(n: int) -> None:
        m = hgp.parametrize(V, F, cones={v: 3 for v in range(8)})
        m.uv, m.fuv, m.certificate, m.cones, m.seams, m.distortion()
        if n % 5 == 0:
            with pytest.raises(hgp.HgpError):
                hgp.parametrize(V, F, cones={0: 3})
            with pytest.raises(hgp.UsageError):
                hgp.parametrize(V, F + 9)

    for n in range(200):
        call(n)
    before = _resident()
    for n in range(1000):
        call(n)
    assert _resident() - before < 1 << 20
