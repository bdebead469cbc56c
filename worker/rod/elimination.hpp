// Block-tridiagonal elimination from end B to end A, 7 x 7 blocks, LDL^T without pivoting (the
// Jacobian is symmetric quasi-definite): R:24, R:26.
#pragma once

namespace hawser::worker {

/// Factors of one eliminated node and what the back-substitution needs.
template <class V>
struct NodeFactor {
    V L[7][7];       ///< unit lower triangle
    V inverse_d[7];  ///< inverse pivots
    V Y[7][7];       ///< L^-1 E
    V z[7];          ///< L^-1 R
};

/// LDL^T of rows and columns first ... first + n - 1 of D (lower triangle given); L and inverse_d
/// are filled from index 0.
template <int first, int n, class V>
[[gnu::always_inline]] inline void factor(const V (&D)[7][7], V (&L)[7][7], V (&inverse_d)[7]) {
    V d[7];
#pragma GCC unroll 7
    for (int j = 0; j < n; ++j) {
        V w[7];
        d[j] = D[first + j][first + j];
#pragma GCC unroll 7
        for (int k = 0; k < j; ++k) {
            w[k] = L[j][k] * d[k];
            d[j] -= L[j][k] * w[k];
        }
        inverse_d[j] = V(1.0) / d[j];
#pragma GCC unroll 7
        for (int i = j + 1; i < n; ++i) {
            V s = D[first + i][first + j];
#pragma GCC unroll 7
            for (int k = 0; k < j; ++k) s -= L[i][k] * w[k];
            L[i][j] = s * inverse_d[j];
        }
    }
}

/// x = L^-1 b.
template <int n, class V>
[[gnu::always_inline]] inline void forward(const V (&L)[7][7], const V* b, V* x) {
#pragma GCC unroll 7
    for (int i = 0; i < n; ++i) {
        V s = b[i];
#pragma GCC unroll 7
        for (int k = 0; k < i; ++k) s -= L[i][k] * x[k];
        x[i] = s;
    }
}

/// x = L^-T b; x may be b. The newest x comes last into each sum: nothing else waits for it.
template <int n, class V>
[[gnu::always_inline]] inline void backward(const V (&L)[7][7], const V* b, V* x) {
#pragma GCC unroll 7
    for (int i = n - 1; i >= 0; --i) {
        V s = b[i];
#pragma GCC unroll 7
        for (int k = n - 1; k > i; --k) s -= L[k][i] * x[k];
        x[i] = s;
    }
}

/// Eliminates a node whose coupling to the next one is E (rows this node, columns the next):
/// D_next -= E^T D^-1 E, R_next -= E^T D^-1 R, R:24. Only the lower triangle of D_next is changed.
///
/// Pivot by pivot: each waits for the division of the one before, and all that a pivot gives to the
/// next node is worked out meanwhile.
template <class V>
inline void eliminate(const V (&D)[7][7], const V (&R)[7], const V (&E)[7][7], NodeFactor<V>& f,
                      V (&D_next)[7][7], V (&R_next)[7]) {
    V u[7][7];  // L times the pivots
#pragma GCC unroll 7
    for (int j = 0; j < 7; ++j) {
        V d = D[j][j];
#pragma GCC unroll 7
        for (int k = 0; k < j; ++k) d -= f.L[j][k] * u[j][k];
        const V inverse = V(1.0) / d;
        f.inverse_d[j] = inverse;
        V y[7], z = R[j];
#pragma GCC unroll 7
        for (int c = 0; c < 7; ++c) {
            y[c] = E[j][c];
#pragma GCC unroll 7
            for (int k = 0; k < j; ++k) y[c] -= f.L[j][k] * f.Y[k][c];
            f.Y[j][c] = y[c];
        }
#pragma GCC unroll 7
        for (int k = 0; k < j; ++k) z -= f.L[j][k] * f.z[k];
        f.z[j] = z;
#pragma GCC unroll 7
        for (int i = j + 1; i < 7; ++i) {
            V s = D[i][j];
#pragma GCC unroll 7
            for (int k = 0; k < j; ++k) s -= f.L[i][k] * u[j][k];
            u[i][j] = s;
            f.L[i][j] = s * inverse;
        }
        const V z_scaled = inverse * z;
#pragma GCC unroll 7
        for (int i = 0; i < 7; ++i) {
            const V scaled = inverse * y[i];
            R_next[i] -= y[i] * z_scaled;
#pragma GCC unroll 7
            for (int k = 0; k <= i; ++k) D_next[i][k] -= scaled * y[k];
        }
    }
}

/// d_n = D_n^-1 (R_n - E_n d_next), R:26 (with J d = R).
template <class V>
inline void substitute(const NodeFactor<V>& f, const V (&d_next)[7], V (&d)[7]) {
    V w[7];
#pragma GCC unroll 7
    for (int i = 0; i < 7; ++i) {
        V s = f.z[i];
#pragma GCC unroll 7
        for (int c = 6; c >= 0; --c) s -= f.Y[i][c] * d_next[c];
        w[i] = f.inverse_d[i] * s;
    }
    backward<7>(f.L, w, d);
}

}  // namespace hawser::worker
