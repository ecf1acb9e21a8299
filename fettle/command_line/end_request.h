#pragma once
// Ends a run when a signal asks for it: Ctrl+C, `kill` or a terminal that closes. The run ends in
// order, as if its window were closed. A second signal ends the process at once, and so does a run
// that does not end in time.

namespace fettle::script {
class Runtime;
}

namespace fettle::program {

/// Handles SIGINT, SIGTERM and SIGHUP while it exists. Only one may exist at a time. A signal that
/// the process already ignores stays ignored.
class EndRequest {
  public:
    EndRequest();
    ~EndRequest();
    EndRequest(const EndRequest&) = delete;
    EndRequest& operator=(const EndRequest&) = delete;

    /// The number of the signal; 0 if none has arrived.
    static int asked();
    /// Scripts may run for `seconds` from now on before they are interrupted; 0: without a limit.
    static void allow(unsigned seconds);

    /// While it exists, the scripts of `runtime` are interrupted if they prevent the end of the
    /// run: one second after the signal, and then every second.
    class Scripts {
      public:
        explicit Scripts(script::Runtime& runtime);
        ~Scripts();
        Scripts(const Scripts&) = delete;
    };
};

}  // namespace fettle::program
