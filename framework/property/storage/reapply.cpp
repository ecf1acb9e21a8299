// Making tweaks of earlier runs again.

#include <fettle/property/path.h>
#include <fettle/property/storage/scene.h>

#include "tweaks_state.h"

namespace fettle::property {

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
    refresh_earlier();
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
