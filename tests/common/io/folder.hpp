// An empty folder for one test, removed with it.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

namespace hawser::test {

class Folder {
 public:
    Folder()
        : path(std::filesystem::temp_directory_path() /
               ("hawser_test_" + std::to_string(::getpid()))) {
        std::filesystem::remove_all(path);
        std::filesystem::create_directories(path);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() { std::filesystem::remove_all(path); }
    const std::filesystem::path path;
};

}  // namespace hawser::test
