#pragma once
// References in scene files by paths from the root, to instances of other files or of scripts. When
// those instances change, the references are changed too.

#include <filesystem>
#include <map>
#include <optional>

#include <fettle/property/storage/tweaks.h>

#include <scenes/scene_edit.h>
#include <tweaks/tweaks_state.h>

namespace fettle::property {

class OtherScenes {
  public:
    /// Reads the loaded scene files when one of them may have to be changed. Reports files with
    /// errors.
    OtherScenes(Tweaks::State& state, TweakReport& report) : state_(state), report_(report) {}

    /// Replaces references to the deleted instance by null; the row stores the old values.
    void forget(const JournalRow& deletion);
    void put_back(const JournalRow& restoration);
    /// Renames in all files except one, which has the new names already.
    void rename(const InstanceMoves& moves, const std::filesystem::path& except);
    /// Writes the files whose text has changed.
    void write();

  private:
    struct Text {
        std::string now, before;
    };
    std::map<std::filesystem::path, Text>& texts();
    template <class Change>
    void change(const std::filesystem::path& file, Text& text, Change change);

    Tweaks::State& state_;
    TweakReport& report_;
    std::optional<std::map<std::filesystem::path, Text>> texts_;
};

}  // namespace fettle::property
