// SPDX-License-Identifier: BSD-3-Clause
// Simulates a job on a cluster, and checks a sample of it. A torus of quads is cut into one part per rank. The program
// makes the message for each rank and measures it. Then it picks some parts at random and refines each of them alone to
// the last level by Catmull-Clark. Each of these parts is verified twice: each of its control faces is refined in a
// tile of its own, and from a level that was refined as a whole. Numbers, vertices and points must be equal bit for
// bit.
// Sample run: virtual_ranks --faces 1000000 --parts 100000 --levels 10 --sample 3
#include "../../tests/support/figures.hpp"

#include <kith/catmull_clark.hpp>
#include <kith/core/mesh/make_mesh.hpp>
#include <kith/metis_partition.hpp>
#include <kith/refine_in_tiles.hpp>
#include <kith/tiles/part/checksum.hpp>
#include <kith/tiles/refine/pack.hpp>

#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <exception>
#include <iomanip>
#include <iostream>
#include <map>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using kith::basic_mesh;
using kith::catmull_clark;
using kith::global_id;
using cutter_type = kith::tile_cutter<std::array<double, 3>, std::uint32_t, catmull_clark>;
using tile_type = kith::tile<std::array<double, 3>, std::uint32_t>;
using levels_type = kith::global_levels_of<catmull_clark>;

struct job {
    std::size_t faces = 10000, parts = 1000, sample = 4;
    int levels = 5;
    std::uint32_t seed = 1;
};

/// A clock for the processor time of this process; other processes do not slow it down.
class stopwatch {
public:
    [[nodiscard]] double seconds() const { return double(std::clock() - start_) / CLOCKS_PER_SEC; }

private:
    std::clock_t start_ = std::clock();
};

/// The mean and the largest value of a quantity over all parts.
struct statistic {
    double sum = 0, largest = 0;
    std::size_t count = 0;

    void add(double value)
    {
        sum += value;
        largest = std::max(largest, value);
        ++count;
    }
    [[nodiscard]] double mean() const { return sum / double(count); }
};

std::ostream& operator<<(std::ostream& out, const statistic& s)
{
    return out << "mean " << s.mean() << ", largest " << s.largest;
}

void require(bool condition, const std::string& what)
{
    if (not condition)
        throw std::runtime_error(what);
}

/// Makes a torus of about `faces` quads, each of a different shape.
basic_mesh<> control_mesh(std::size_t faces)
{
    const auto rows = std::max<std::size_t>(3, std::size_t(std::sqrt(double(faces) / 2)));
    auto shape = figures::torus(rows, std::max<std::size_t>(3, faces / rows));
    std::mt19937 random(7);
    for (auto& point : shape.points)
        for (double& x : point)
            x += 0.01 * double(random() % 1000) / 1000 / std::sqrt(double(faces));
    return kith::make_mesh(shape.points, shape.faces);
}

levels_type whole_of(cutter_type& cutter, int levels)
{
    auto rim = cutter.cut_rim(kith::ring_schedule(catmull_clark{}, levels, 1)[0]);
    return {cutter.counts(), std::move(rim.part), std::move(rim.scheme), levels};
}

/// Measures the messages that the ranks would get, and prints the sizes of the levels that they would make.
void plan_messages(const job& wanted, cutter_type& cutter, const levels_type& whole)
{
    statistic owned, ghosts, bytes;
    const stopwatch watch;
    for (std::size_t p = 0; p < cutter.parts(); ++p) {
        const auto cut = cutter.cut(p, whole.rings(0));
        const auto faces = double(cutter.faces(p).size());
        owned.add(faces);
        if (faces != 0)
            ghosts.add((double(cut.part.mesh.face_count()) - faces) / faces);
        bytes.add(double(kith::pack(cut).size()));
    }
    const double seconds = watch.seconds(), growth = std::pow(4., wanted.levels);
    const auto last = whole.counts(wanted.levels);
    std::cout << "control faces of a part: " << owned << "\nghost faces per owned face: " << ghosts
              << "\nbytes of a message: " << bytes << "\nall messages: " << bytes.sum << " bytes, " << seconds
              << " s to cut and pack on one core\nlevel " << wanted.levels << ": " << double(last.faces) << " faces, "
              << double(last.vertices) << " vertices; a part: mean " << owned.mean() * growth << ", largest "
              << owned.largest * growth << " faces\nbytes sent per face: " << bytes.sum / double(last.faces) << '\n';
    require(last.faces == cutter.counts().faces << (2 * wanted.levels),
            "the faces are not four times as many each level");
    require(last.vertices + last.faces == last.edges, "the counts are not those of a torus");
}

struct refined {
    std::map<global_id, kith::mesh_checksum> checksums; ///< by control face
    std::uint64_t owned = 0, kept = 0, made = 0;        ///< numbers of faces, on all levels but the first
    std::uint64_t last_bytes = 0;
    global_id largest_vertex = 0;
};

/// Refines one part alone. The children of quad f on a level l are the faces 4^l f ... 4^l (f + 1) - 1 there.
refined refine_part(cutter_type& cutter, const levels_type& whole, std::size_t part)
{
    refined result;
    auto cut = cutter.cut(part, whole.rings(0));
    std::uint64_t corners = cut.part.mesh.corner_count();
    const auto fine = kith::refine(
        std::move(cut.part), std::move(cut.scheme), whole, kith::connect::faces, [&](const tile_type& level) {
            result.made += corners; // one quad per corner
            result.kept += level.mesh.face_count();
            result.owned += std::uint64_t(std::ranges::count_if(
                level.face_marks, [](unsigned char mark) { return (mark & kith::owned_mark) != 0; }));
            corners = level.mesh.corner_count();
        });
    const auto shift = 2 * whole.levels();
    const auto& roots = cutter.faces(part);
    require(fine.face_ids.size() == roots.size() << shift, "a tile has lost faces");
    for (std::size_t i = 0; i < fine.face_ids.size(); ++i)
        require(fine.face_ids[i] == (global_id(roots[i >> shift]) << shift) + (i & ((std::size_t(1) << shift) - 1)),
                "a face has another number than its quad says");
    result.largest_vertex = *std::ranges::max_element(fine.vertex_ids);
    const auto checksums = kith::checksums_of_roots(fine);
    for (std::size_t r = 0; r < checksums.size(); ++r)
        if (std::ranges::binary_search(roots, fine.roots[r]))
            result.checksums.emplace(fine.roots[r], checksums[r]);
    const auto bytes = [](const auto&... array) { return ((array.size() * sizeof(array[0])) + ...); };
    result.last_bytes = bytes(fine.mesh.points(),
                              fine.mesh.topology().corner_vertex,
                              fine.vertex_ids,
                              fine.vertex_marks,
                              fine.face_ids,
                              fine.face_marks,
                              fine.root_of);
    return result;
}

/// Returns a partition in which each face is a part of its own.
std::vector<std::uint32_t> alone(std::size_t faces)
{
    std::vector<std::uint32_t> part_of(faces);
    std::iota(part_of.begin(), part_of.end(), 0U);
    return part_of;
}

void verify_sample(const job& wanted, const basic_mesh<>& control, cutter_type& cutter, const levels_type& whole)
{
    const catmull_clark scheme;
    const auto singles = alone(control.face_count());
    cutter_type one_by_one(control, scheme, singles, control.face_count());

    const auto prefix = kith::refine(control, scheme, 1);
    std::vector<std::uint32_t> parent(prefix.face_count());
    for (std::size_t f = 0; f < parent.size(); ++f)
        parent[f] = std::uint32_t(f / 4);
    cutter_type from_prefix(prefix, scheme, parent, control.face_count());
    const auto later = whole_of(from_prefix, wanted.levels - 1);

    std::mt19937 random(wanted.seed);
    double seconds = 0;
    refined all;
    for (std::size_t i = 0; i < wanted.sample; ++i) {
        std::size_t part = random() % cutter.parts();
        while (cutter.faces(part).empty())
            part = (part + 1) % cutter.parts();
        const stopwatch watch;
        const auto alone = refine_part(cutter, whole, part);
        seconds += watch.seconds();
        all.owned += alone.owned;
        all.kept += alone.kept;
        all.made += alone.made;
        all.last_bytes = std::max(all.last_bytes, alone.last_bytes);
        all.largest_vertex = std::max(all.largest_vertex, alone.largest_vertex);
        require(alone.checksums.size() == cutter.faces(part).size(), "a control face has no children");
        for (const auto& [face, checksum] : alone.checksums) {
            require(refine_part(one_by_one, whole, face).checksums.at(face) == checksum,
                    "part " + std::to_string(part) + ": control face " + std::to_string(face) +
                        " is another surface in a tile of its own");
            kith::mesh_checksum sum;
            for (const auto& [child, of_child] : refine_part(from_prefix, later, face).checksums)
                sum += of_child;
            require(sum == checksum,
                    "part " + std::to_string(part) + ": control face " + std::to_string(face) +
                        " is another surface when level 1 is refined as a whole");
        }
        std::cout << "part " << part << ": " << cutter.faces(part).size() << " control faces, verified\n";
    }
    const auto last = double(whole.counts(wanted.levels).faces);
    std::cout << "faces kept per face owned, all levels: " << double(all.kept) / double(all.owned)
              << ", made: " << double(all.made) / double(all.owned)
              << "\nlargest number of a vertex seen: " << all.largest_vertex << ", "
              << double(all.largest_vertex) / 4294967296. << " times 2^32"
              << "\nlast level of a part: up to " << all.last_bytes << " bytes\nrefined " << double(all.made) / seconds
              << " faces per second; all of the job: " << last * seconds / (double(all.owned) * 3 / 4) / 3600
              << " core hours\n";
}

job job_from(int count, char** words)
{
    namespace po = boost::program_options;
    job wanted;
    po::options_description options("Options");
    options.add_options()("faces", po::value(&wanted.faces))("parts", po::value(&wanted.parts))(
        "levels", po::value(&wanted.levels))("sample", po::value(&wanted.sample))("seed", po::value(&wanted.seed));
    po::variables_map values;
    po::store(po::parse_command_line(count, words, options), values);
    po::notify(values);
    require(wanted.levels > 0 and wanted.faces >= 9 and wanted.parts > 0,
            "ask for a level, nine faces and a part at least");
    return wanted;
}

} // namespace

int main(int count, char** words)
{
    try {
        const auto wanted = job_from(count, words);
        std::cout << std::setprecision(5);
        const auto control = control_mesh(wanted.faces);
        const stopwatch watch;
        const auto parts = kith::metis_partition(control, wanted.parts);
        std::cout << control.face_count() << " quads in " << wanted.parts << " parts by METIS in " << watch.seconds()
                  << " s\n";
        const catmull_clark scheme;
        cutter_type cutter(control, scheme, parts.part_of, parts.parts);
        const auto whole = whole_of(cutter, wanted.levels);
        plan_messages(wanted, cutter, whole);
        if (wanted.sample != 0)
            verify_sample(wanted, control, cutter, whole);
    } catch (const std::exception& failure) {
        std::cerr << "virtual_ranks: " << failure.what() << '\n';
        return 1;
    }
}
