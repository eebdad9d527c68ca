// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <cstddef>
#include <vector>

/// V-cycles of multigrid for stiffness matrices whose null space is the constants. The prolongations are ordered from
/// level 0 up; the coarse operators follow from them and the finest operator.
class multigrid {
public:
    using matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

    multigrid(const matrix& finest, const std::vector<matrix>& prolongations) : prolongations_(prolongations)
    {
        operators_.assign(prolongations.size() + 1, finest);
        for (std::size_t level = prolongations.size(); level-- > 0;)
            operators_[level] = prolongations[level].transpose() * operators_[level + 1] * prolongations[level];
        const Eigen::MatrixXd coarsest(operators_[0]);
        coarse_solver_.compute(coarsest + Eigen::MatrixXd::Constant(coarsest.rows(), coarsest.cols(), 1));
    }
    /// Improves the solutions of A u = b, one per column.
    template <class Columns>
    void cycle(Columns& u, const Columns& b) const
    {
        cycle(prolongations_.size(), u, b);
    }

private:
    template <class Columns>
    void cycle(std::size_t level, Columns& u, const Columns& b) const
    {
        if (level == 0) {
            u = coarse_solver_.solve(b);
            return;
        }
        const matrix &a = operators_[level], &p = prolongations_[level - 1];
        smooth<false>(a, u, b), smooth<true>(a, u, b);
        Columns correction = Columns::Zero(p.cols(), b.cols());
        cycle<Columns>(level - 1, correction, p.transpose() * (b - a * u));
        u += p * correction;
        smooth<false>(a, u, b), smooth<true>(a, u, b);
    }
    /// Smooths by Gauss & Seidel's method, forwards or backwards.
    template <bool Backwards, class Columns>
    static void smooth(const matrix& a, Columns& u, const Columns& b)
    {
        for (Eigen::Index k = 0; k < a.rows(); ++k) {
            const Eigen::Index row = Backwards ? a.rows() - 1 - k : k;
            Eigen::Matrix<double, 1, Columns::ColsAtCompileTime> rest = b.row(row);
            double diagonal = 1;
            for (matrix::InnerIterator entry(a, row); entry; ++entry)
                if (entry.col() == row)
                    diagonal = entry.value();
                else
                    rest -= entry.value() * u.row(entry.col());
            u.row(row) = rest / diagonal;
        }
    }

    const std::vector<matrix>& prolongations_;
    std::vector<matrix> operators_;
    Eigen::LDLT<Eigen::MatrixXd> coarse_solver_;
};
