# SPDX-License-Identifier: BSD-3-Clause
"""Connection to the workers."""
import contextlib
import logging
import os
import tempfile

from ..command import Failure

TIMEOUT = "20s"  # for the scheduler, and for its first worker


def _dask():
    os.environ.setdefault("DASK_LOGGING__DISTRIBUTED", "critical")  # here and in workers: lost workers are not errors
    try:
        import distributed
    except ImportError as error:
        raise Failure("Dask is not installed; on Debian: apt install python3-distributed") from error
    return distributed


@contextlib.contextmanager
def connect(scheduler):
    """A client of the scheduler at this address. Without an address: of a local scheduler with one worker per core."""
    distributed = _dask()
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
            client.wait_for_workers(1, timeout=TIMEOUT)
        except (OSError, TimeoutError, distributed.TimeoutError) as error:
            raise Failure(f"--scheduler {scheduler}: found no scheduler with workers at this address ({error})") from None
        yield client
