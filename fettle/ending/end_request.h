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
    static int signal();
    /// After a signal, scripts may run for `seconds` from now on before they are interrupted; 0:
    /// without a limit.
    static void limit_scripts(unsigned seconds);

    /// While it exists, the scripts of `runtime` are interrupted if they prevent the end of the
    /// run: one second after the signal, and then every second.
    class Scripts {
      public:
        explicit Scripts(script::Runtime& runtime);
        ~Scripts();
        Scripts(const Scripts&) = delete;
    };

    /// While it exists, a first SIGINT does not end the run: it stops the present work, a command
    /// or the line that is typed. A second one that arrives before `test_and_clear` ends the run.
    class Interrupts {
      public:
        Interrupts();
        ~Interrupts();
        Interrupts(const Interrupts&) = delete;

        static bool arrived();  ///< true from the signal to `test_and_clear`
        static bool
        test_and_clear();  ///< whether the signal had arrived; the next one is a first one
    };

    /// While it exists, the signal of `Interrupts` interrupts the scripts of `Scripts` at once.
    /// They may run again when it ends.
    class Command {
      public:
        Command();
        ~Command();
        Command(const Command&) = delete;
    };
};

}  // namespace fettle::program
