#pragma once
// What SFML does not tell about the X server. All of it is false on other systems.

namespace fettle::app::sfml {

/// Whether there is an X server.
bool has_x11();
/// Whether the key left of the 1 is held down, whatever letter the layout of the keyboard gives it.
bool is_key_left_of_1_down();

}  // namespace fettle::app::sfml
