// Keeping tweaks, making them again, dropping them.

#include <algorithm>
#include <map>
#include <optional>

#include "scene_edit.h"
#include "tweaks_state.h"

namespace fettle::property {

namespace fs = std::filesystem;

namespace {

using Kind = JournalRow::Kind;
using RowState = JournalRow::State;

/// The parent's path of a path of an instance, and its last name.
std::pair<std::string, std::string> split_path(const std::string& path) {
    std::vector<Segment> segments = parse_path(path);
    const std::string name = std::get<std::string>(segments.back().key);
    const std::string suffix = path_suffix(name);
    if (segments.size() == 1) return {"game", name};
    return {path.substr(0, path.size() - suffix.size()), name};
}

Handle instance_at(const Tree& tree, const std::string& path) {
    const Place place = resolve(tree, path);
    if (place.property != nullptr)
        throw Error(ErrorKind::unknown_name, path + " is a property now, not an instance");
    return place.instance;
}

/// Files that are being changed: read when first needed, written together at the end.
class Keeping {
  public:
    Keeping(Tweaks::State& state, TweakReport& report) : state_(state), report_(report) {}

    void keep(JournalRow& row) {
        try {
            const fs::path file = scene_file(row);
            if (file.empty())
                into_kept(row);
            else
                into_scene(row, file);
        } catch (const Error& error) {
            report_.problems.push_back(path_of(row) + ": " + error.what());
        }
    }

    void write() {
        for (auto& [file, scene] : scenes_)
            finish(file, scene.rows, [&, &path = file, &edit = scene.edit] {
                if (edit) state_.files.write(path, edit->text());
            });
        finish(state_.kept.file(), kept_rows_, [&] { state_.kept.write(); });
    }

  private:
    struct Scene {
        std::optional<SceneEdit> edit;
        std::vector<JournalRow*> rows;
    };

    /// Empty when it is none of the game's own: what was loaded from elsewhere is not ours to
    /// write.
    fs::path scene_file(const JournalRow& row) const {
        std::error_code error;
        if (row.file.empty()) return {};
        fs::path file = fs::weakly_canonical(row.file, error);
        const fs::path relative = file.lexically_relative(state_.folder);
        if (error || relative.empty() || *relative.begin() == ".." || !state_.files.exists(file))
            return {};
        return file;
    }

    SceneEdit& scene(const fs::path& file) {
        Scene& scene = scenes_[file];
        if (!scene.edit) scene.edit.emplace(state_.tree, state_.files.read(file), file.string());
        return *scene.edit;
    }

    Handle scene_top(const JournalRow& row) const {
        try {
            const auto origin = state_.origins.find(instance_at(state_.tree, row.instance));
            return origin ? origin->top : Handle{};
        } catch (const Error&) {
            return {};
        }
    }

    void into_scene(JournalRow& row, const fs::path& file) {
        const SceneSteps steps = read_steps(row.inside);
        switch (row.kind) {
            case Kind::value:
                scene(file).set(steps, row.property, told(row), scene_top(row));
                break;
            case Kind::created:
                scene(file).add_child(steps, row.now);
                break;
            case Kind::deleted:
                if (steps.empty()) return into_kept(row);
                scene(file).remove(steps);
                break;
            case Kind::moved:
                if (split_path(row.instance).first != split_path(row.now).first)
                    throw Error(ErrorKind::rejected,
                                "another parent cannot be kept: move it in the file");
                scene(file).rename(steps, split_path(row.now).second);
                break;
        }
        scenes_[file].rows.push_back(&row);
    }

    void into_kept(JournalRow& row) {
        switch (row.kind) {
            case Kind::value:
                state_.kept.set(row.instance, row.property, told(row));
                break;
            case Kind::created:
                state_.kept.add(row.instance, row.now);
                break;
            case Kind::deleted:
                state_.kept.remove(row.instance);
                break;
            case Kind::moved:
                throw Error(
                    ErrorKind::rejected,
                    "a name or parent that a script gives cannot be kept: change the script");
        }
        kept_rows_.push_back(&row);
    }

    Image told(const JournalRow& row) const {
        Image image = read_image(row.now);
        if (image.kind == Image::Kind::value && !image.not_saved.empty())
            throw Error(ErrorKind::rejected, image.not_saved);
        if (image.kind == Image::Kind::formula && !image.not_saved.empty())
            report_.problems.push_back(path_of(row) + ": its formula " + image.not_saved +
                                       ", so its value is kept instead");
        return image;
    }

    template <class Write>
    void finish(const fs::path& file, const std::vector<JournalRow*>& rows, Write write) {
        if (rows.empty()) return;
        try {
            write();
        } catch (const Error& error) {
            report_.problems.emplace_back(error.what());
            return;
        }
        report_.files.push_back(file.string());
        report_.count += rows.size();
        for (JournalRow* row : rows) {
            row->kept_in = file.filename().string();
            state_.set_state(*row, RowState::kept);
        }
    }

    Tweaks::State& state_;
    TweakReport& report_;
    std::map<fs::path, Scene> scenes_;
    std::vector<JournalRow*> kept_rows_;
};

}  // namespace

std::vector<JournalRow*> Tweaks::State::matching(std::string_view text, bool earlier_only) {
    const TweakPattern pattern(text);
    std::vector<JournalRow*> rows;
    for (JournalRow& row : earlier)
        if (row.state == RowState::open && pattern.matches(row)) rows.push_back(&row);
    if (earlier_only) return rows;
    for (const auto& each : entries)
        if (each->row.state == RowState::open && visible(*each) && pattern.matches(each->row))
            rows.push_back(&each->row);
    return rows;
}

void Tweaks::State::set_state(JournalRow& row, RowState state) {
    row.state = state;
    rest = 0;
    if (row.run == JournalRow::elsewhere) return;
    if (row.run != 0) return changed.push_back(&row);
    Entry& its = *entries[static_cast<std::size_t>(row.number) - 1];
    if (its.dirty) return;
    its.dirty = true;
    dirty.push_back(&its);
}

TweakReport Tweaks::State::keep(std::string_view pattern) {
    TweakReport report;
    rest = 0;
    barrier();  // whatever was edited just now counts as well
    Keeping keeping(*this, report);
    for (JournalRow* row : matching(pattern, false)) keeping.keep(*row);
    keeping.write();
    barrier();
    return report;
}

TweakReport Tweaks::State::drop(std::string_view pattern) {
    TweakReport report;
    barrier();
    for (JournalRow* row : matching(pattern, false)) {
        set_state(*row, RowState::dropped);
        ++report.count;
    }
    barrier();
    return report;
}

namespace {

/// Whatever it does is one edit, scripts' or not.
class EditScope {
  public:
    EditScope(Tree& tree, const std::string& name) : tree_(tree) { tree_.begin_edit(name); }
    ~EditScope() { tree_.end_edit(); }
    EditScope(const EditScope&) = delete;

  private:
    Tree& tree_;
};

}  // namespace

TweakReport Tweaks::State::reapply(std::string_view pattern) {
    TweakReport report;
    const std::vector<JournalRow*> rows = matching(pattern, true);
    const EditScope edit(tree, "reapply tweaks of " + std::string(pattern));
    for (JournalRow* row : rows) {
        try {
            switch (row->kind) {
                case Kind::value: {
                    const Image image = read_image(row->now);
                    if (image.kind == Image::Kind::value && !image.not_saved.empty())
                        throw Error(ErrorKind::rejected, image.not_saved);
                    apply_image(tree, instance_at(tree, row->instance), row->property, image);
                    if (!image.not_saved.empty())
                        report.problems.push_back(path_of(*row) + ": its formula " +
                                                  image.not_saved +
                                                  ", so its value is set instead");
                    break;
                }
                case Kind::created: {
                    const auto [parent, name] = split_path(row->instance);
                    const Handle at = instance_at(tree, parent);
                    if (tree.child(at, name))
                        throw Error(ErrorKind::bad_name, "there is something of this name already");
                    born(load_scene_text(tree, row->now, "journal", at, name));
                    break;
                }
                case Kind::deleted:
                    tree.destroy(instance_at(tree, row->instance));
                    break;
                case Kind::moved: {
                    const auto [parent, name] = split_path(row->now);
                    const Handle moved = instance_at(tree, row->instance);
                    const Handle to = instance_at(tree, parent);
                    if (tree.parent(moved) == to)
                        tree.rename(moved, name);
                    else
                        tree.move(moved, to, name);
                    break;
                }
            }
            ++report.count;
            set_state(*row, RowState::dropped);
        } catch (const Error& error) {
            report.problems.push_back(path_of(*row) + ": " + error.what());
        }
    }
    return report;
}

}  // namespace fettle::property
