#include "catch.h"

#include <ostream>
#include <string>

namespace checks {

namespace {

const char* macro_of(Disposition disposition, bool match) {
    const bool ends = (disposition & go_on) == 0;
    if (match) return ends ? "REQUIRE_THAT" : "CHECK_THAT";
    if ((disposition & not_true) != 0) return ends ? "REQUIRE_FALSE" : "CHECK_FALSE";
    return ends ? "REQUIRE" : "CHECK";
}

// In Catch2 3 nothing deletes such an expression through its base, whose destructor is not virtual.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wnon-virtual-dtor"
class Reported final : public Catch::ITransientExpression {
  public:
    explicit Reported(const Outcome& outcome)
        : ITransientExpression(outcome.right != nullptr, outcome.holds), outcome_(outcome) {}

    void streamReconstructedExpression(std::ostream& out) const override {
        const std::string left = outcome_.show_left(outcome_.left);
        if (outcome_.right == nullptr) {
            out << left;
            return;
        }
        const std::string right = outcome_.show_right(outcome_.right);
        if (outcome_.comparison == nullptr)
            out << left << ' ' << right;
        else
            Catch::formatReconstructedExpression(out, left, outcome_.comparison, right);
    }

  private:
    const Outcome& outcome_;
};
#pragma GCC diagnostic pop

void report(const Outcome& outcome, const char* macro, const char* text, const char* file,
            unsigned line, Disposition disposition) {
    Catch::AssertionHandler handler(macro, Catch::SourceLineInfo(file, line), text, disposition);
    handler.handleExpr(Reported(outcome));
    handler.complete();
}

}  // namespace

std::string shown_text(const void* value) {
    return Catch::Detail::stringify(static_cast<const char*>(value));
}

void check(const Outcome& outcome, const char* text, const char* file, unsigned line,
           Disposition disposition) {
    report(outcome, macro_of(disposition, false), text, file, line, disposition);
}

void check_match(const Outcome& outcome, const char* text, const char* file, unsigned line,
                 Disposition disposition) {
    report(outcome, macro_of(disposition, true), text, file, line, disposition);
}

}  // namespace checks
