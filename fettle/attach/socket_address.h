#pragma once
// The address of a local socket, as the system calls take it.

#include <sys/socket.h>
#include <sys/un.h>

#include <cstring>
#include <filesystem>
#include <optional>

namespace fettle::program {

class SocketAddress {
  public:
    /// None if the path is longer than the system allows, about a hundred bytes.
    static std::optional<SocketAddress> of(const std::filesystem::path& path) {
        SocketAddress made;
        const std::string& text = path.native();
        if (text.size() >= sizeof made.address_.sun_path) return std::nullopt;
        made.address_.sun_family = AF_UNIX;
        std::memcpy(made.address_.sun_path, text.c_str(), text.size() + 1);
        return made;
    }
    const sockaddr* any() const { return reinterpret_cast<const sockaddr*>(&address_); }
    socklen_t size() const { return sizeof address_; }

  private:
    sockaddr_un address_{};
};

}  // namespace fettle::program
