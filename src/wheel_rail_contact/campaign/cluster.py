# SPDX-License-Identifier: BSD-3-Clause
"""Connection to the workers."""
import asyncio
import contextlib
import logging
import os
import tempfile
import time

from ..command import Failure

TIMEOUT = 20  # for the scheduler, and for its first worker [s]
POLL_PERIOD = 0.1  # between checks for the first worker [s]


def dask():
    """The module distributed. Raises Failure if it is not installed, or too old."""
    os.environ.setdefault("DASK_LOGGING__DISTRIBUTED", "critical")  # here and in workers: lost workers are not errors
    try:
        import distributed
    except ImportError as error:
        raise Failure(f"Dask cannot be imported ({error}); on Debian: "
                      "apt install python3-distributed python3-tornado") from error
    if not hasattr(distributed.Client, "nthreads"):
        raise Failure(f"Dask {distributed.__version__} is too old; run: python3 -m pip install --user distributed")
    return distributed


def _wait_for_worker(client):
    """Waits for the first worker. The method wait_for_workers has no timeout in the oldest supported version."""
    end = time.monotonic() + TIMEOUT
    while not client.nthreads():
        if time.monotonic() > end:
            raise TimeoutError(f"no worker after {TIMEOUT} s")
        time.sleep(POLL_PERIOD)


@contextlib.contextmanager
def connect(scheduler):
    """A client of the scheduler at this address. Without an address: of a local scheduler with one worker per core."""
    distributed = dask()
    with contextlib.ExitStack() as stack:
        if scheduler:
            target = scheduler
        else:
            folder = stack.enter_context(tempfile.TemporaryDirectory())
            target = stack.enter_context(distributed.LocalCluster(
                n_workers=len(os.sched_getaffinity(0)), threads_per_worker=1, memory_limit=0, host="127.0.0.1",
                dashboard_address="127.0.0.1:0", local_directory=folder, preload=[f"{__package__}.no_interrupts"],
                silence_logs=logging.CRITICAL))
        try:
            client = stack.enter_context(distributed.Client(target, timeout=TIMEOUT))
            _wait_for_worker(client)
        except (OSError, TimeoutError, asyncio.TimeoutError) as error:
            raise Failure(f"--scheduler {scheduler}: found no scheduler with workers at this address ({error})") from None
        yield client
