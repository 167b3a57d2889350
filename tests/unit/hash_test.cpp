// SHA-256 against the published examples of FIPS 180-4 (NIST, "Examples with Intermediate Values", SHA256).
#include "scree/base/hash.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

TEST(Sha256, PublishedExamples) {
  EXPECT_EQ(sha256_hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_hex("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256_hex(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, PiecesGiveTheHashOfTheWhole) {
  const std::string whole(1000, 'a');
  for (const std::size_t piece : {1U, 63U, 64U, 65U, 999U}) {
    Sha256 hash;
    for (std::size_t at = 0; at < whole.size(); at += piece) {
      const std::string part = whole.substr(at, piece);
      hash.update(part.data(), part.size());
    }
    EXPECT_EQ(hash.hex(), sha256_hex(whole)) << piece;
  }
}

}  // namespace
}  // namespace scree
