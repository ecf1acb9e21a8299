#include <console/echoes.h>

#include <algorithm>
#include <iterator>

#include <lua/machine.h>
#include <objects/hints.h>
#include <text/columns.h>
#include <text/folded_rows.h>
#include <values/recording.h>

namespace fettle::script {

namespace {

/// Old and new value of an edit, or what else it did; with what may be meant by a new name, which
/// takes time to find.
std::string echo(Machine& machine, const Recording::Edit& edit, bool same, bool with_hint) {
    const bool added = with_hint && !edit.added.empty() && machine.tree.alive(edit.instance);
    const std::string hint =
        added ? machine.hints.of_added(edit.instance, edit.added) : std::string();
    if (!edit.note.empty()) return edit.path + ": " + edit.note + hint;
    std::string line = edit.path + ": ";
    if (!same) line += cut(machine.tree.text(edit.before, edit.precision), 60) + " → ";
    line += cut(machine.tree.text(edit.after, edit.precision), 60);
    if (!edit.unit.empty()) line += " " + edit.unit;
    if (edit.replaced)
        line += " (replaces its formula)";
    else if (same)
        line += " (unchanged)";
    return line + hint;
}

}  // namespace

void add_echoes(Machine& machine, Evaluation& evaluation) {
    const auto& edits = machine.recording.edits;
    std::vector<std::string> lines;
    for (const auto& edit : edits) {
        const bool same = edit.note.empty() && edit.before == edit.after && !edit.replaced;
        if (!same || edits.size() == 1)
            lines.push_back(echo(machine, edit, same, lines.size() < shown_changes));
    }
    FoldedLines folded;
    fold_rows(lines,
              {.shown = shown_changes,
               .total = lines.size() + machine.recording.dropped,
               .what = "changes"},
              folded);
    folded.line += evaluation.lines.size();
    if (!folded.lines.empty()) evaluation.folded.push_back(std::move(folded));
    std::ranges::move(lines, std::back_inserter(evaluation.lines));
}

}  // namespace fettle::script
