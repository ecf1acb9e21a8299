#pragma once
// Errors of one line of a script between two barriers: a method that fails for one instance of a
// class often fails for all of them.

#include <map>
#include <string>
#include <vector>

#include <fettle/script/runtime.h>

namespace fettle::program {

class RepeatedErrors {
  public:
    /// Counts the error. Returns false if one of the same place was counted since the last `take`;
    /// an error in a chunk that a person typed is never a repetition.
    bool first(const script::ScriptError& error);
    /// Returns a sentence for each place that failed again, and forgets all places.
    std::vector<std::string> take();

  private:
    struct Place {
        int further = 0;
        std::string last;  // context of the last error
    };
    std::map<std::string, Place> places_;
};

}  // namespace fettle::program
