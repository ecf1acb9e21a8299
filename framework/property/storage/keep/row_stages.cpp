#include <keep/row_stages.h>

#include <algorithm>
#include <utility>

#include <values/instance_paths.h>

namespace fettle::property {

using Kind = JournalRow::Kind;

Rows without_moves(const Rows& rows) {
    Rows others;
    for (JournalRow* row : rows)
        if (row->kind != Kind::moved) others.push_back(row);
    return others;
}

Rows moves_in(const Rows& rows) {
    Rows moves;
    for (JournalRow* row : rows)
        if (row->kind == Kind::moved) moves.push_back(row);
    return moves;
}

Stage stage_of(const JournalRow& row, const Rows& rows) {
    switch (row.kind) {
        case Kind::deleted:
            return std::ranges::any_of(rows,
                                       [&](const JournalRow* other) {
                                           return other->kind == Kind::restored &&
                                                  other->instance != row.instance &&
                                                  is_at_or_below(row.instance, other->instance);
                                       })
                       ? Stage::deleted_below_restored
                       : Stage::deleted;
        case Kind::restored:
            return Stage::restored;
        case Kind::created:
            return Stage::created;
        case Kind::moved:
            return Stage::moved;
        case Kind::value:
            break;
    }
    return Stage::value;
}

Rows in_stages(const Rows& rows) {
    std::vector<std::pair<Stage, JournalRow*>> stages;
    stages.reserve(rows.size());
    for (JournalRow* row : rows) stages.emplace_back(stage_of(*row, rows), row);
    std::ranges::stable_sort(stages, {}, [](const auto& each) { return each.first; });
    Rows ordered;
    for (const auto& [stage, row] : stages) ordered.push_back(row);
    return ordered;
}

}  // namespace fettle::property
