# SPDX-License-Identifier: BSD-3-Clause
"""Where the work is done."""
import contextlib
import logging
import os
import tempfile

from ..command import Failure

PATIENCE = "20s"  # for the scheduler, and for its first worker


def _dask():
    try:
        import distributed
    except ImportError as error:
        raise Failure("Dask is not installed; on Debian: apt install python3-distributed") from error
    return distributed


@contextlib.contextmanager
def connect(scheduler):
    """A client of the scheduler at an address; of one of its own, with a worker for each core, if there is none."""
    distributed = _dask()
    logging.getLogger("distributed").setLevel(logging.CRITICAL)  # lost workers are no fault of the user's
    with contextlib.ExitStack() as stack:
        if scheduler:
            target = scheduler
        else:
            folder = stack.enter_context(tempfile.TemporaryDirectory())
            target = stack.enter_context(distributed.LocalCluster(
                n_workers=len(os.sched_getaffinity(0)), threads_per_worker=1, memory_limit=0, host="127.0.0.1",
                dashboard_address=None, local_directory=folder, silence_logs=logging.CRITICAL))
        try:
            client = stack.enter_context(distributed.Client(target, timeout=PATIENCE))
            client.wait_for_workers(1, timeout=PATIENCE)
        except (OSError, TimeoutError, distributed.TimeoutError) as error:
            raise Failure(f"--scheduler {scheduler}: no scheduler with workers there ({error})") from None
        yield client
