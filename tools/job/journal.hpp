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

/// Returns the recipe that a journal's directory keeps. Errors: file_error if there is none, or if it is damaged.
recipe kept_recipe(const std::string& directory);

/// Returns the recipe that a journal's directory keeps. If there is none, returns a recipe of this request with the
/// partition that `make` returns. Errors: file_error for the recipe of another refinement.
found_recipe recipe_for(const std::string& directory, const tile_request& request,
                        const std::function<partition()>& make);

/// Throws file_error if the output and the journal are on different file systems. The surface gets its name by
/// renaming, which works within one file system only.
void require_one_file_system(const std::string& output, const std::string& directory);

/// Throws file_error if the output is one of the journal's own files.
void require_apart(const std::string& output, const std::string& directory);

/// A job's share in a journal. Several jobs may work in one journal at the same time. Each job locks the surface
/// (flock, shared) during its lifetime, so that no job takes the surface away from another. The class is move-only.
class journal_share {
public:
    /// Begins the journal, unless it exists already. The recipe appears when it is complete, so that a process that
    /// ends early leaves no partial recipe.
    /// Errors: file_error. Causes include an output on another file system, and a journal that another job has begun
    /// with another recipe. A file in the place of the surface that is not a surface is an error as well.
    journal_share(std::string directory, const found_recipe& recipe, const std::string& output);
    journal_share(journal_share&& other) noexcept;
    journal_share& operator=(journal_share&&) = delete;
    ~journal_share();

    [[nodiscard]] static std::string surface_in(const std::string& directory);
    /// Returns the path of the records of a surface while the surface gets its name.
    [[nodiscard]] static std::string records_in(const std::string& directory);

    /// Returns true if another job has given the surface its name since the recipe was read; there is nothing left to
    /// share.
    [[nodiscard]] bool is_over() const { return descriptor_ < 0; }
    /// Waits until no other job works in the journal. Returns false if another job has given the surface its name
    /// meanwhile. Precondition: all tiles are finished.
    [[nodiscard]] bool own();
    /// Removes the journal, and its directory if nothing else is in it. Precondition: the surface has its name.
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
