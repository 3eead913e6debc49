// Emscripten starts programs with an invented environment; tests under Node want the real one.
Module['preRun'] = [
  function () {
    if (typeof ENV !== 'undefined') Object.assign(ENV, process.env);
  },
];
