#pragma once
// The text of a kept deletion: all that the deletion removed from the files. When an undo of the
// deletion is kept, the text is put back. Instances in the text may get other names in the
// meantime.

#include <filesystem>
#include <string>

#include <scenes/scene_origins.h>
#include <values/instance_paths.h>

namespace fettle::property {

/// The home path, after renames in the files, of an instance that was removed from them: only the
/// instances above it are renamed. Another instance may have its path now.
std::string home_of_removed(const std::string& home, const NewPath& now_at);
/// The same for its steps in a scene file.
SceneSteps steps_of_removed(const SceneSteps& steps, const SceneOrigins::Names& names);

/// The text after instances got other home paths. `removed`: the home path of the deleted instance
/// before. An invalid text is returned unchanged.
std::string with_new_homes(const Tree& tree, const std::string& text, const std::string& removed,
                           const NewPath& now_at);

/// The text after a scene file got other names of instances. `removed`: the steps of the deleted
/// instance before, or null if it is not from that file.
std::string with_new_steps(const std::string& text, const SceneSteps* removed,
                           const std::filesystem::path& file, const SceneOrigins::Names& names);

}  // namespace fettle::property
