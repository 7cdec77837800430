// Four doubles a record, and packs of doubles.
#pragma once

#include "../numbers/lanes.h"

namespace plait {
inline namespace PLAIT_ISA {

using Record = Pack<4, double>;

// Four numbers from memory, of either precision.
inline Record record(const double* from) { return load<Record>(from); }
inline Record record(const float* from) {
    const auto four = load<Pack<4>>(from);
    return Record(__builtin_convertvector(four.v, Record::V));
}
inline void keepRecord(double* to, const Record& r) { store(to, r); }
inline void keepRecord(float* to, const Record& r) {
    store(to, Pack<4>(__builtin_convertvector(r.v, Pack<4>::V)));
}

namespace detail {

template <bool high>
Record paired(const Record& a, const Record& b) {
    constexpr int i = high ? 1 : 0;
    return Record(__builtin_shufflevector(a.v, b.v, i, i + 4, i + 2, i + 6));
}
template <bool high>
Record halves(const Record& a, const Record& b) {
    constexpr int i = high ? 2 : 0;
    return Record(__builtin_shufflevector(a.v, b.v, i, i + 1, i + 4, i + 5));
}

// Rows to columns.
inline void turnRecords(Record* r) {
    const Record a = paired<false>(r[0], r[1]), b = paired<true>(r[0], r[1]);
    const Record c = paired<false>(r[2], r[3]), d = paired<true>(r[2], r[3]);
    r[0] = halves<false>(a, c), r[1] = halves<false>(b, d);
    r[2] = halves<true>(a, c), r[3] = halves<true>(b, d);
}

}  // namespace detail

// One record a lane to four packs, and back.
template <class T>
void columns(const Record* records, T* out) {
    if constexpr (Lanes<T>::count == 1) {
        for (int k = 0; k < 4; ++k) out[k] = records[0].v[k];
    } else if constexpr (Lanes<T>::count == 2) {
        const auto &a = records[0].v, &b = records[1].v;
        out[0] = T(__builtin_shufflevector(a, b, 0, 4)),
        out[1] = T(__builtin_shufflevector(a, b, 1, 5));
        out[2] = T(__builtin_shufflevector(a, b, 2, 6)),
        out[3] = T(__builtin_shufflevector(a, b, 3, 7));
    } else if constexpr (Lanes<T>::count == 4) {
        for (int k = 0; k < 4; ++k) out[k] = records[k];
        detail::turnRecords(out);
    } else {
        Record low[4], high[4];
        columns(records, low);
        columns(records + 4, high);
        for (int k = 0; k < 4; ++k)
            out[k] = T(__builtin_shufflevector(low[k].v, high[k].v, 0, 1, 2, 3, 4, 5, 6, 7));
    }
}
template <class T>
void records(const T* columns, Record* out) {
    if constexpr (Lanes<T>::count == 1) {
        out[0] = Record(Record::V{columns[0], columns[1], columns[2], columns[3]});
    } else if constexpr (Lanes<T>::count == 2) {
        const auto a = __builtin_shufflevector(columns[0].v, columns[1].v, 0, 2, 1, 3),
                   b = __builtin_shufflevector(columns[2].v, columns[3].v, 0, 2, 1, 3);
        out[0] = Record(__builtin_shufflevector(a, b, 0, 1, 4, 5));
        out[1] = Record(__builtin_shufflevector(a, b, 2, 3, 6, 7));
    } else if constexpr (Lanes<T>::count == 4) {
        for (int k = 0; k < 4; ++k) out[k] = columns[k];
        detail::turnRecords(out);
    } else {
        Record low[4], high[4];
        for (int k = 0; k < 4; ++k) {
            low[k] = Record(__builtin_shufflevector(columns[k].v, columns[k].v, 0, 1, 2, 3));
            high[k] = Record(__builtin_shufflevector(columns[k].v, columns[k].v, 4, 5, 6, 7));
        }
        records(low, out);
        records(high, out + 4);
    }
}

}  // namespace PLAIT_ISA
}  // namespace plait
