// Ctrl-C ends a filter's run. Python only notes the signal while C++ code runs in its main thread, and acts on it when
// Python code runs again: here, in an observer.
%pythoncode %{
def _run_interruptibly(filter, update):
    """Update the filter; a signal handler that raises, like that of Ctrl-C, aborts it and its exception is raised."""
    import itk
    import signal
    import threading

    handler = signal.getsignal(signal.SIGINT)
    if threading.current_thread() is not threading.main_thread() or not callable(handler):
        return update()

    raised = []

    def handle(number, frame):
        try:
            handler(number, frame)
        except BaseException as exception:
            # ITK would print it and lose its type if it went through an observer.
            raised.append(exception)
            filter.AbortGenerateDataOn()

    observer = filter.AddObserver(itk.ProgressEvent(), lambda: None)
    signal.signal(signal.SIGINT, handle)
    try:
        update()
    except RuntimeError:
        if not raised:
            raise
    finally:
        signal.signal(signal.SIGINT, handler)
        filter.RemoveObserver(observer)
    if raised:
        raise raised[0]
%}
