// SPDX-License-Identifier: Apache-2.0
using NUnit.Framework;

public class LoadsTest {
  [Test]
  public void TheLibraryIsFoundAndBelongsToTheBinding() { Assert.AreEqual(1u, Hapticut.Library.AbiVersion); }
}
