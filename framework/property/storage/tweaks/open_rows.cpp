// Finding, marking and dropping open tweaks.

#include <string_view>
#include <utility>
#include <vector>

#include <tweaks/tweaks_state.h>

namespace fettle::property {

using RowState = JournalRow::State;

std::vector<JournalRow*> Tweaks::State::matching(std::string_view text, bool earlier_only) {
    const TweakPattern pattern(text);
    std::vector<JournalRow*> rows;
    for (JournalRow& row : earlier.rows)
        if (row.state == RowState::open && pattern.matches(row)) rows.push_back(&row);
    if (earlier_only) return rows;
    for (const auto& each : entries)
        if (each->row.state == RowState::open && visible(*each) && pattern.matches(each->row))
            rows.push_back(&each->row);
    return rows;
}

void Tweaks::State::add_kept_for_one(std::vector<JournalRow*>& rows, std::string_view text) {
    const TweakPattern pattern(text);
    for (const auto& each : entries) {
        JournalRow& row = each->row;
        if (row.kind == Kind::value && row.state == RowState::kept && !row.file.empty() &&
            row.kept_in == kept.file().filename().string() && !each->away && !each->gone &&
            pattern.matches(row))
            rows.push_back(&row);
    }
}

void Tweaks::State::refresh_earlier() {
    if (!journal) return;
    journal->refresh(earlier.rows);
    for (JournalRow& row : earlier.rows)
        if (row.state == RowState::open && !problem_of(row).empty()) row.state = RowState::dropped;
}

void Tweaks::State::set_state(JournalRow& row, RowState state) {
    row.state = state;
    barriers_to_retry = 0;
    if (row.run == JournalRow::elsewhere) return;
    if (row.run > 0) return earlier.changed.push_back(&row);
    Entry& its = entry_of(row);
    index(its);
    add_to_dirty(its);
    if (state == RowState::dropped) its.dropped_version = last_version;
    if (state != RowState::kept) return;
    its.kept_version = its.version;
    if (row.run == JournalRow::left_behind) {
        its.row.kept_in = row.kept_in;  // it is listed as kept where it holds
        return;
    }
    if (row.kind == Kind::value) its.in_file = its.now;
    // A file that has lost an instance does not describe it any more.
    if (const auto made = by_instance.created.find(its.handle.key());
        row.kind == Kind::deleted && made != by_instance.created.end())
        made->second->kept_version = 0;
}

/// Returns the number of dropped rows. Rows without a valid path match only the pattern "**".
std::size_t Tweaks::State::drop_invalid(std::string_view text) {
    const TweakPattern pattern(text);
    return std::erase_if(earlier.invalid, [&](JournalRow& row) {
        try {
            if (text != "**" && !pattern.matches(row)) return false;
        } catch (const Error&) {
            return false;
        }
        barriers_to_retry = 0;
        if (row.run != JournalRow::elsewhere) earlier.removed.push_back(std::move(row));
        return true;
    });
}

TweakReport Tweaks::State::drop(std::string_view pattern) {
    TweakReport report;
    barrier();
    refresh_earlier();
    for (JournalRow* row : matching(pattern, false)) {
        set_state(*row, RowState::dropped);
        // Otherwise a row that was made again, and undone, would be open again.
        std::erase_if(earlier.reapplied, [&](const auto& each) { return each.first == row; });
        ++report.count;
    }
    report.count += drop_invalid(pattern);
    barrier();
    return report;
}

}  // namespace fettle::property
