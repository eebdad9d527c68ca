// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "recipe.hpp"

#include <functional>
#include <optional>
#include <string>

namespace kith::tool {

/// The recipe of a refinement, and whether a journal has it already.
struct found_recipe {
    recipe value;
    bool is_kept = false;
};

/// The recipe that a journal's directory keeps. Errors: file_error when there is none, or it is damaged.
recipe kept_recipe(const std::string& directory);

/// The recipe that a journal's directory keeps or, where there is none, one of this request with the partition that
/// `make` gives. Errors: file_error for the recipe of another refinement.
found_recipe recipe_for(const std::string& directory, const tile_request& request,
                        const std::function<partition()>& make);

/// The surface gets its name by renaming, which no file system does for another. Errors: file_error.
void require_one_file_system(const std::string& output, const std::string& directory);

/// A journal has files of its own, which an output must not be. Errors: file_error.
void require_apart(const std::string& output, const std::string& directory);

/// A job's share in a journal. Jobs may be at work in one at the same time: each holds the surface (flock, shared)
/// while it lives, so that none takes the surface away from another. Move only.
class journal_share {
public:
    /// Begins the journal, unless it is there already. The recipe appears when it is complete, so that a process that
    /// is ended meanwhile leaves no half of one.
    /// Errors: file_error, also when the output is on another file system, when another job has begun otherwise, and
    /// for a file in the place of the surface that is none.
    journal_share(std::string directory, const found_recipe& recipe, const std::string& output);
    journal_share(journal_share&& other) noexcept;
    journal_share& operator=(journal_share&&) = delete;
    ~journal_share();

    [[nodiscard]] static std::string surface_in(const std::string& directory);
    /// Where the records of a surface lie while it gets its name.
    [[nodiscard]] static std::string records_in(const std::string& directory);

    /// Whether another job has given the surface its name since the recipe was read, so that there is nothing to share.
    [[nodiscard]] bool is_over() const { return descriptor_ < 0; }
    /// When all tiles are finished: waits until no other job is at work here. False when one of those has given the
    /// surface its name meanwhile.
    [[nodiscard]] bool own();
    /// When the surface has its name: nothing of the journal is left, nor of the directory if nothing else is in it.
    void remove() noexcept;

private:
    explicit journal_share(std::string directory);
    [[nodiscard]] bool hold();
    void leave() noexcept;
    [[nodiscard]] bool is_of_others() const;
    [[nodiscard]] bool holds_surface() const;

    // The names are made once, so that removing the files needs no memory.
    std::string directory_;
    std::string surface_ = surface_in(directory_);
    std::string records_ = records_in(directory_);
    std::string recipe_;
    int descriptor_ = -1;
};

} // namespace kith::tool
