#pragma once
// A run that is asked to end by a signal: Ctrl+C, `kill`, a terminal that goes. It ends in order,
// as if its window were closed; a second signal ends it at once, and so does the time it
// may take.

namespace fettle::script {
class Runtime;
}

namespace fettle::program {

/// Listens for SIGINT, SIGTERM and SIGHUP while it lives. There is one at a time. A signal that the
/// process was told to ignore stays ignored.
class EndRequest {
  public:
    EndRequest();
    ~EndRequest();
    EndRequest(const EndRequest&) = delete;
    EndRequest& operator=(const EndRequest&) = delete;

    /// The number of the signal; 0 while nobody has asked.
    static int asked();
    /// The script has so many seconds from now on; 0: as many as it likes.
    static void allow(unsigned seconds);

    /// While it lives, the scripts of that runtime are stopped when they let nothing end: a second
    /// after the signal, and every second from then on.
    class Scripts {
      public:
        explicit Scripts(script::Runtime& runtime);
        ~Scripts();
        Scripts(const Scripts&) = delete;
    };
};

}  // namespace fettle::program
