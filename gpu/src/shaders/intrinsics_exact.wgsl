// Correctly rounded division and square root, for a device whose own results are off by up to three units in the last
// place.
//
// The result of the device serves as a guess for the 24 leading bits, which is then corrected by its remainder.
// Integers have only 32 bits here, which hold the low bits of the remainder. Since the remainder is small, these bits
// are all of it. If an operand or the result is not a normal number, the result of the device is kept.
const LEADING_BIT: u32 = 0x800000u;
fn leading_bits(x: u32) -> u32 { return (x & 0x7fffffu) | LEADING_BIT; }
fn exponent(x: u32) -> i32 { return i32((x >> 23u) & 0xffu); }
fn is_normal(x: u32) -> bool { let e = exponent(x); return e > 0 && e < 255; }
// If the exponent of the guess is off by one, its leading bits are shifted by one place.
fn moved_to(guess: u32, wanted: i32) -> u32 {
  let bits = leading_bits(guess);
  if exponent(guess) > wanted { return bits << 1u; }
  if exponent(guess) < wanted { return bits >> 1u; }
  return bits;
}

fn div(x: R, y: R) -> R {
  let quotient = x / y;
  let a = bitcast<u32>(x);
  let b = bitcast<u32>(y);
  let divisor = leading_bits(b);
  // the quotient of the leading bits lies in [1/2, 2); below 1 it takes one more place
  let below_one = select(0u, 1u, leading_bits(a) < divisor);
  let e = exponent(a) - exponent(b) + 127 - i32(below_one);
  var bits = moved_to(bitcast<u32>(quotient), e);
  var remainder = bitcast<i32>((leading_bits(a) << (23u + below_one)) - bits * divisor);
  for (var i = 0u; i < 4u; i += 1u) {
    if remainder < 0 { bits -= 1u; remainder += i32(divisor); }
    if remainder >= i32(divisor) { bits += 1u; remainder -= i32(divisor); }
  }
  // there are no ties: the product of a quotient of 25 bits and a divisor of 24 bits would need 47 bits
  if 2 * remainder > i32(divisor) { bits += 1u; }
  let sign = (a ^ b) & 0x80000000u;
  let exact = sign | ((u32(e) << 23u) + bits - LEADING_BIT);
  let normal = is_normal(a) && is_normal(b) && e > 0 && e < 254;
  return select(quotient, bitcast<f32>(exact), normal);
}

fn root(x: R) -> R {
  let guess = sqrt(x);
  let a = bitcast<u32>(x);
  let odd = u32((exponent(a) - 127) & 1);
  let e = ((exponent(a) - 127) >> 1u) + 127;
  var bits = moved_to(bitcast<u32>(guess), e);
  var remainder = bitcast<i32>((leading_bits(a) << (23u + odd)) - bits * bits);
  for (var i = 0u; i < 4u; i += 1u) {
    if remainder < 0 { bits -= 1u; remainder += i32(2u * bits + 1u); }
    if remainder > i32(2u * bits) { remainder -= i32(2u * bits + 1u); bits += 1u; }
  }
  // round up beyond the middle: (bits + 1/2)^2 = bits^2 + bits + 1/4
  if remainder > i32(bits) { bits += 1u; }
  let exact = bitcast<f32>((u32(e) << 23u) + bits - LEADING_BIT);
  return select(guess, exact, is_normal(a) && (a >> 31u) == 0u);
}
