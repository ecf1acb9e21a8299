#include "report/bounds.h"

#include <cstdio>
#include <ostream>

namespace fettle::bench {
namespace {

std::string plain(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", number);
    return text;
}

}  // namespace

bool Bound::holds(double figure) const {
    switch (kind) {
        case Kind::none:
            return true;
        case Kind::below:
            return figure < value;
        case Kind::at_most:
            return figure <= value;
        case Kind::at_least:
            return figure >= value;
        case Kind::exactly:
            return figure == value;
        case Kind::other_than:
            return figure < value || figure > value;
    }
    return false;
}

std::string Bound::text() const {
    switch (kind) {
        case Kind::none:
            return "";
        case Kind::below:
            return "< " + plain(value);
        case Kind::at_most:
            return "<= " + plain(value);
        case Kind::at_least:
            return ">= " + plain(value);
        case Kind::exactly:
            return plain(value);
        case Kind::other_than:
            return "not " + plain(value);
    }
    return "";
}

std::string text_with_note(const Bound& bound) {
    const std::string text = bound.text();
    if (text.empty() || bound.note.empty()) return text + bound.note;
    return text + ": " + bound.note;
}

std::string Verdict::mark(const std::string& row, double figure, const Bound& bound,
                          const std::string& shown, const std::string& against) {
    if (!bound) return shown;
    ++bounds_;
    if (bound.holds(figure)) return shown;
    exceeded_.push_back("\"" + row + "\" " + shown + (against.empty() ? "" : " " + against) +
                        " (bound " + bound.text() + ")");
    return shown + " !";
}

void Verdict::print(std::ostream& out) const {
    out << "\n"
        << bounds_ << (bounds_ == 1 ? " bound, " : " bounds, ") << exceeded_.size()
        << " exceeded\n";
    for (const std::string& figure : exceeded_)
        out << "exceeded: " << table_ << " " << figure << "\n";
}

}  // namespace fettle::bench
