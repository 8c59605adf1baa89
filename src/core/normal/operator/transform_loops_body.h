// SPDX-License-Identifier: BSD-3-Clause
// Included by lanes_body.h. No include guard.

/// Calls body(offset, offset in spread values) for all registers of a block.
template <typename Body>
inline void forEach(const BlockLines& blocks, int pitch, const Body& body)
{
  const int run = blocks.unit == pitch ? blocks.count * blocks.unit : blocks.unit;
  for (int at = 0, spread = 0; at < blocks.count * blocks.unit; at += run, spread += pitch)
  {
    for (int i = 0; i < run; i += register_width)
    {
      body(at + i, spread + i);
    }
  }
}

/// The same with the rotations c, s, c', s' of the values.
template <typename Body>
inline void forEachTurn(const BlockLines& blocks, int pitch, const double* turns, const Body& body)
{
  const int table = roundUpToLanes(blocks.count);
  if (blocks.unit == 1)
  {
    for (int n = 0; n < blocks.count; n += register_width)
    {
      const double* t = turns + n;
      body(n, n, load(t), load(t + table), load(t + 2 * table), load(t + 3 * table));
    }
    return;
  }
  const Register zero = {};
  for (int n = 0; n < blocks.count; ++n)
  {
    const double* t = turns + n;
    const Register c = zero + t[0], s = zero + t[table], c_alt = zero + t[2 * table], s_alt = zero + t[3 * table];
    for (int i = 0; i < blocks.unit; i += register_width)
    {
      body(n * blocks.unit + i, n * pitch + i, c, s, c_alt, s_alt);
    }
  }
}

void butterfly(const BlockLines& blocks, double* data)
{
  const int size = blocks.count * blocks.unit;
  for (int line = 0; line < blocks.lines; ++line, data += blocks.stride)
  {
    for (int i = 0; i < size; i += register_width)
    {
      const Register a = load(data + i), b = load(data + size + i);
      store(data + i, a + b);
      store(data + size + i, a - b);
    }
  }
}

void turn(const BlockLines& blocks, const double* turns, double* data)
{
  const int size = blocks.count * blocks.unit;
  for (int line = 0; line < blocks.lines; ++line, data += blocks.stride)
  {
    forEachTurn(blocks, blocks.unit, turns,
                [=](int i, int, Register c, Register s, Register c_alt, Register s_alt)
                {
                  const Register a = load(data + i), b = load(data + size + i);
                  store(data + i, c * a + s * b);
                  store(data + size + i, c_alt * b - s_alt * a);
                });
  }
}

void turnBack(const BlockLines& blocks, const double* turns, double* data)
{
  const int size = blocks.count * blocks.unit;
  for (int line = 0; line < blocks.lines; ++line, data += blocks.stride)
  {
    forEachTurn(blocks, blocks.unit, turns,
                [=](int i, int, Register c, Register s, Register c_alt, Register s_alt)
                {
                  const Register u = load(data + i), v = load(data + size + i);
                  store(data + i, c * u - s_alt * v);
                  store(data + size + i, s * u + c_alt * v);
                });
  }
}

void split(const BlockLines& blocks, const double* turns, const Spread& spread, const double* in, double* out)
{
  const int size = blocks.count * blocks.unit, mirror = blocks.count * spread.pitch;
  for (int line = 0; line < blocks.lines; ++line, in += spread.stride, out += blocks.stride)
  {
    forEach(blocks, spread.pitch,
            [=](int i, int from)
            {
              const Register a = load(in + from), b = load(in + mirror + from);
              store(out + i, a + b);
              store(out + size + i, a - b);
            });
    if (turns)
    {
      forEachTurn(blocks, spread.pitch, turns,
                  [=](int i, int from, Register c, Register s, Register c_alt, Register s_alt)
                  {
                    const Register a = load(in + from), b = load(in + mirror + from);
                    store(out + 2 * size + i, c * a + s * b);
                    store(out + 3 * size + i, c_alt * b - s_alt * a);
                  });
    }
  }
}

void join(const BlockLines& blocks, const double* turns, const Spread& spread, const double* in, double* out)
{
  const int size = blocks.count * blocks.unit, mirror = blocks.count * spread.pitch;
  for (int line = 0; line < blocks.lines; ++line, in += blocks.stride, out += spread.stride)
  {
    forEach(blocks, spread.pitch,
            [=](int i, int to)
            {
              const Register s = load(in + i), t = load(in + size + i);
              store(out + to, s + t);
              store(out + mirror + to, s - t);
            });
    if (turns)
    {
      forEachTurn(blocks, spread.pitch, turns,
                  [=](int i, int to, Register c, Register s, Register c_alt, Register s_alt)
                  {
                    const Register u = load(in + 2 * size + i), v = load(in + 3 * size + i);
                    store(out + to, load(out + to) + c * u - s_alt * v);
                    store(out + mirror + to, load(out + mirror + to) + s * u + c_alt * v);
                  });
    }
  }
}

/// A two by two matrix with the elements 0, +1 and -1: a' = Aa a + Ab b, b' = Ba a + Bb b.
template <int Aa, int Ab, int Ba, int Bb>
struct Pairing
{
  template <typename Number>
  static void apply(Number& a, Number& b)
  {
    const Number old_a = a;
    a = double{Aa} * old_a + double{Ab} * b;
    b = double{Ba} * old_a + double{Bb} * b;
  }
};

/// Applies First to the first values of two blocks (mode 0) and Rest to all others.
template <typename First, typename Rest>
inline void combineBlocks(const BlockLines& blocks, double* data)
{
  const int size = blocks.count * blocks.unit;
  for (int line = 0; line < blocks.lines; ++line, data += blocks.stride)
  {
    double first_a = data[0], first_b = data[size];
    for (int i = 0; i < size; i += register_width)
    {
      Register a = load(data + i), b = load(data + size + i);
      if (blocks.unit > 1 && i < blocks.unit)
      {
        First::apply(a, b);
      }
      else
      {
        Rest::apply(a, b);
      }
      store(data + i, a);
      store(data + size + i, b);
    }
    if (blocks.unit == 1)
    {
      First::apply(first_a, first_b);
      data[0] = first_a;
      data[size] = first_b;
    }
  }
}

void combine(const BlockLines& blocks, Combination combination, double* data)
{
  switch (combination)
  {
    case Combination::forwards:
      combineBlocks<Pairing<1, 0, 0, -1>, Pairing<1, 1, 1, -1>>(blocks, data);
      break;
    case Combination::backwards:
      combineBlocks<Pairing<0, -1, 1, 0>, Pairing<1, -1, 1, 1>>(blocks, data);
      break;
    case Combination::backwards_transposed:
      combineBlocks<Pairing<0, 1, -1, 0>, Pairing<1, 1, -1, 1>>(blocks, data);
      break;
  }
}
