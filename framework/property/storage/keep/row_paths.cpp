#include <keep/row_paths.h>

#include <algorithm>

#include <scenes/scene_names.h>

namespace fettle::property {

using Kind = JournalRow::Kind;
using RowState = JournalRow::State;

RowPaths::RowPaths(const Tweaks::State& state) : state_(&state), now_(state.moves()) {
    for (const JournalRow& row : state.earlier.rows)
        if (row.kind == Kind::moved && row.state != RowState::kept)
            earlier_[row.run].add(row.instance, row.now);
}

const InstanceMoves& RowPaths::moves_of(const JournalRow& row) const {
    static const InstanceMoves none;
    if (row.run == 0) return now_;
    const auto found = earlier_.find(row.run);
    return found == earlier_.end() ? none : found->second;
}

std::string RowPaths::home(const JournalRow& row, const std::string& path) const {
    return moves_of(row).home(path);
}

std::string RowPaths::home(const JournalRow& row) const {
    const bool names_home = row.kind != Kind::value && row.kind != Kind::created;
    return names_home ? row.instance : home(row, row.instance);
}

std::string RowPaths::home_of_new_parent(const JournalRow& row) const {
    return home(row, split_path(row.now).first);
}

std::string RowPaths::home_of_top(const JournalRow& row) const {
    const std::string own = home(row);
    const std::vector<Segment> names =
        parse_path(row.kind == Kind::created ? split_path(own).first : own);
    return joined_path(names, names.size() - std::min(names.size(), read_steps(row.inside).size()));
}

std::string RowPaths::moved_out_of(const JournalRow& deletion) const {
    for (const JournalRow& row : state_->earlier.rows)
        if (row.kind == Kind::moved && row.state == RowState::open &&
            row.instance != deletion.instance && is_at_or_below(row.instance, deletion.instance))
            return row.now;
    return now_.moved_out_of(deletion.instance);
}

std::string RowPaths::path_in_rows(const JournalRow& row, const std::string& home) const {
    return row.kind == Kind::value || row.kind == Kind::created
               ? without_marks(moves_of(row).now(home))
               : home;
}

std::string RowPaths::home_of_live(const std::string& path) const {
    return now_.home(path);
}

Handle RowPaths::instance(const std::string& home) const {
    return instance_or_none(state_->tree, without_marks(now_.now(home)));
}

std::string RowPaths::live(const JournalRow& row, const std::string& path) const {
    return without_marks(now_.now(home(row, path)));
}

Image RowPaths::live_image(const JournalRow& row) const {
    Image image = read_image(row.now);
    if (image.kind == Image::Kind::value && !image.not_saved.empty())
        throw Error(ErrorKind::rejected, image.not_saved);
    image.value = value_with_paths(
        image.value, [&](const std::string& path) { return std::optional(live(row, path)); });
    return image;
}

void RowPaths::each_named(const JournalRow& row,
                          const std::function<void(const std::string& home)>& visit) const {
    const NewPath look = [&](const std::string& home) -> std::optional<std::string> {
        visit(home);
        return std::nullopt;
    };
    try {
        if (row.kind == Kind::value)
            (void)value_with_paths(live_image(row).value, [&](const std::string& path) {
                return look(home_of_live(path));
            });
        else if (row.kind == Kind::created || row.kind == Kind::restored)
            (void)home_scene(row, look);
    } catch (const Error&) {  // the error is reported on writing
    }
}

bool RowPaths::needs(const JournalRow& row, const std::string& home) const {
    bool needed = is_at_or_below(this->home(row), home);
    if (!needed)
        each_named(row, [&](const std::string& at) { needed |= is_at_or_below(at, home); });
    return needed;
}

std::string RowPaths::home_scene(const JournalRow& row, const NewPath& written) const {
    return scene_with_paths(
        state_->tree, row.now, [&](const std::string& path) -> std::optional<std::string> {
            const std::string at_home = home(row, path);
            const std::optional<std::string> other = written ? written(at_home) : std::nullopt;
            return other ? other : at_home;
        });
}

}  // namespace fettle::property
