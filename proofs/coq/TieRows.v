(* Written by proofs/coq/tie.py: (degree, knots, [(span, parameter, what et_basis_eval gives)]). *)
Require Import List Floats.
Import ListNotations.
Local Open Scope float_scope.
Local Open Scope list_scope.

Definition rows_0 : list (nat * list float * list (nat * float * list float)) := [
(3%nat, [0; 0; 0; 0; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (3%nat, 0x1bf15f2e283a7fp-53, [0x10b20ed89a21f5p-61; 0x158f68077838abp-57; 0x128fbe901cf61p-50; 0x5539e0a2859d3p-51]);
  (3%nat, 1, [0; 0; 0; 1]);
  (3%nat, 0x5p-3, [0x1bp-9; 0x87p-9; 0xe1p-9; 0x7dp-9])]);
(3%nat, [0; 0; 0; 0; 0xccccccccccccdp-55; 0x13333333333333p-54; 0xb333333333333p-52; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (5%nat, 0x13333333333333p-54, [0x18618618618617p-54; 0x8b8362e0d8b83p-52; 0x25ed097b425edp-53; 0]);
  (6%nat, 0xb79185e79f99bp-52, [0x1eadd4da2fd7f7p-56; 0x10534e92197817p-53; 0x17aae9c0261e97p-54; 0x181f28d7da04e9p-65]);
  (6%nat, 1, [0; 0; 0; 1])]);
(3%nat, [0; 0; 0; 0; 0x1p-1; 0x10000000000001p-53; 0x8000000000001p-52; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (3%nat, 0x91a6940d3e66fp-53, [0xa407402a4775fp-55; 0xa2605fe56a817p-53; 0x1aca4af8bfdf63p-54; 0x1792de1281297bp-55]);
  (5%nat, 0x10000000000001p-53, [0x7ffffffffffffp-104; 0xfffffffffffffp-52; 0x1p-53; 0]);
  (6%nat, 1, [0; 0; 0; 1])]);
(3%nat, [0; 0; 0; 0; 0x1p-1; 0x1p-1; 0x1p-1; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (3%nat, 0xeaf3ac7d3661p-50, [0x1447a7a438ac5bp-55; 0xce61a846cba85p-53; 0xaf05ce481d781p-53; 0xc5e7ab80d0b8bp-55]);
  (6%nat, 0x1p-1, [1; 0; 0; 0]);
  (6%nat, 1, [0; 0; 0; 1]);
  (3%nat, 0x3p-4, [0x7dp-9; 0xe1p-9; 0x87p-9; 0x1bp-9])]);
(3%nat, [0; 0; 0; 0; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (7%nat, 0x1p-1, [1; 0; 0; 0]);
  (7%nat, 0xe8c0883d77ec3p-52, [0x188a5a846f3debp-60; 0xa5dd30a4ae7ffp-55; 0xbad722da5ff69p-53; 0x4628116af9a07p-51]);
  (7%nat, 1, [0; 0; 0; 1])]);
(3%nat, [0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0]);
  (5%nat, 0x1a10cde1573d33p-53, [0x1a1f9da8aa3c69p-60; 0x560ea5367472bp-54; 0x179fdcad3e07a3p-54; 0x8a5aea22e021p-48]);
  (5%nat, 1, [0; 0; 0; 1])]);
(2%nat, [0; 0; 0; 1; 2; 3; 4; 4; 5; 5; 5],
 [(2%nat, 0, [1; 0; 0]);
  (3%nat, 0x1f8a7dcd008cdp-48, [0xd7c11355538e9p-63; 0x4391197590ef1p-51; 0x78c2d4f273777p-52]);
  (5%nat, 3, [0x1p-1; 0x1p-1; 0]);
  (7%nat, 5, [0; 0; 1])]);
(0%nat, [-3; 0x1p-3; 7],
 [(0%nat, -3, [1]);
  (0%nat, -0xb6f8b893d3bf9p-50, [1]);
  (1%nat, 7, [1])]);
(1%nat, [0; 0; 0x15555555555555p-54; 0x1ccccccccccccdp-53; 0x1ccccccccccccdp-53; 1; 1],
 [(1%nat, 0, [1; 0]);
  (1%nat, 0xac47cd326001p-52, [0xdfb289868dffdp-52; 0x204d767972003p-52]);
  (4%nat, 0x1ccccccccccccdp-53, [1; 0]);
  (4%nat, 1, [0; 1])]);
(2%nat, [-1; -0x1p-1; 0; 0x1p-2; 0x1p-2; 2; 0x5p-1; 3],
 [(2%nat, 0, [0x15555555555555p-54; 0x15555555555555p-53; 0]);
  (2%nat, 0x7d8259e28549p-52, [0x8364e7f61a3abp-53; 0xba75032288e63p-52; 0x1ec447134fe3f9p-59]);
  (4%nat, 0x1p-2, [1; 0; 0]);
  (4%nat, 2, [0; 0x71c71c71c71c7p-53; 0x31c71c71c71c7p-50])]);
(3%nat, [0; 1; 2; 3; 4; 5; 6; 7; 8; 9],
 [(3%nat, 3, [0x15555555555555p-55; 0x15555555555555p-53; 0x15555555555555p-55; 0]);
  (4%nat, 4, [0x15555555555555p-55; 0x15555555555555p-53; 0x15555555555555p-55; 0]);
  (4%nat, 0x12485f24def659p-50, [0x36057ad82d789p-56; 0x6f1587ab32f8bp-52; 0x2167081a54fc7p-50; 0xfdc007bec7c09p-57]);
  (5%nat, 5, [0x15555555555555p-55; 0x15555555555555p-53; 0x15555555555555p-55; 0]);
  (5%nat, 6, [0; 0x15555555555555p-55; 0x15555555555555p-53; 0x15555555555555p-55])]);
(3%nat, [0; 0; 0; 0; 0x1p-50; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (4%nat, 0x1p-50, [0x1ffffffffffffp-49; 0x3ffffffffffffp-99; 0x1p-100; 0]);
  (4%nat, 0x233bac5e95615p-50, [0x173f66c82139abp-56; 0x556b74ce73551p-52; 0xd13d9b376a329p-53; 0xaad95b36d95fdp-54]);
  (4%nat, 1, [0; 0; 0; 1])]);
(3%nat, [0x31p60; 0x31p60; 0x31p60; 0x31p60; 0x31p61; 0x31p61; 0x31p61; 0x31p61],
 [(3%nat, 0x31p60, [1; 0; 0; 0]);
  (3%nat, 0x434bfe8ad606fp16, [0xfbeb2fc6381cfp-54; 0x1c2603bce3687dp-54; 0x10c64351b320bp-50; 0x1aa82fa82fa815p-57]);
  (3%nat, 0x31p61, [0; 0; 0; 1])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0xccccccccccccdp-54; 0x1ccccccccccccdp-54; 0x1ccccccccccccdp-54; 0xccccccccccccdp-52; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (6%nat, 0x560b51a4cb4a3p-52, [0x7a7e636ffbe7fp-60; 0xd5b07af9bab0dp-57; 0x18c94c13efe503p-54; 0xeb9925c222373p-53; 0x1f66aaa2a9a4f3p-56; 0x1fe3fc51f67e3p-58]);
  (9%nat, 1, [0; 0; 0; 0; 0; 1])]);
(7%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0x13333333333333p-54; 0x13333333333333p-54; 0x13333333333333p-54; 0x13333333333333p-54; 0x13333333333333p-54; 0x13333333333333p-54; 0x13333333333333p-54; 0x13d70a3d70a3d7p-54; 1; 1; 1; 1; 1; 1; 1; 1],
 [(7%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0]);
  (14%nat, 0x13333333333333p-54, [1; 0; 0; 0; 0; 0; 0; 0]);
  (15%nat, 0x13d70a3d70a3d7p-54, [0x1d5a6efcb4fd97p-53; 0x146b6e99890979p-56; 0x5eb329bcead6bp-59; 0x3a8ef0ff549d9p-64; 0x145e3d9076799dp-73; 0x1e3a3c33251085p-81; 0x12b0fee306d787p-89; 0]);
  (15%nat, 0x18b70afbcf1c83p-53, [0x332bce6214fabp-61; 0x17339fb698ce97p-60; 0x9039ba6ba3a57p-56; 0xf8e772f60c001p-55; 0x202fdc78cbf2bp-51; 0x27e2269073117p-51; 0x1b54030cd04765p-55; 0x1f0d33d7962ebbp-57]);
  (15%nat, 1, [0; 0; 0; 0; 0; 0; 0; 1])]);
(4%nat, [0; 0; 0; 0; 0; 0x13c3df01021709p-53; 0x33p-6; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (6%nat, 1, [0; 0; 0; 0; 1]);
  (6%nat, 0x33p-6, [0x167231f8a8b597p-58; 0x71f4bc59ea6b1p-53; 0xa70bdce9d99f5p-52; 0x34ba70d60dfb7p-53; 0]);
  (5%nat, 0xaf535b050a733p-52, [0xe3801877e36d1p-61; 0x1e526c3b09750bp-56; 0x1bc86587cd224bp-54; 0x7194c5abe83cbp-52; 0x10aefdb3ba6c9bp-61]);
  (4%nat, 0x3897ecd22af15p-53, [0x74556880d923bp-52; 0x1b48499f872af9p-54; 0xe039637eaec0bp-55; 0x26e645acb0627p-56; 0x9f01b34a9128fp-63]);
  (4%nat, -1, [1; 0; 0; 0; 0]);
  (6%nat, 0x1ffffffffffffdp-53, [0x825f0d094de59p-253; 0xadd41161bd31fp-200; 0x15ba822c37a637p-149; 0xec4ec4ec4ec3fp-99; 0xfffffffffffe3p-52])]);
(4%nat, [0; 0; 0; 0; 0; 0x17p-6; 0x21p-6; 0x1bp-5; 0x1bp-5; 0x1bp-5; 0x1bp-5; 0xfeb4b24d8f493p-52; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (11%nat, 1, [0; 0; 0; 0; 1]);
  (5%nat, 0x17p-6, [0xe3f458882553dp-57; 0xd473284fa3cc5p-53; 0x6e4875cc5cb63p-52; 0x102f29a3c81c85p-55; 0]);
  (5%nat, 0x61p-8, [0x10b3ed64a9cc2fp-58; 0xbdccee722ff61p-53; 0x1d3b553b4b5959p-54; 0x4ffd5e05a3463p-53; 0x897dbe8979583p-68]);
  (4%nat, 0x3e0ee2859872fp-52, [0xb7d0eaad3f225p-58; 0xe472526dc3493p-54; 0x1103c27052fee3p-53; 0xd4ca13e07888dp-54; 0x6b38f3f2417e1p-56]);
  (4%nat, -1, [1; 0; 0; 0; 0]);
  (11%nat, 0x1ffffffffffffbp-53, [0xf7440655052c5p-239; 0x1ee880caa0a485p-190; 0x5cb9825fe1e8bp-139; 0xf744065504fe1p-93; 0x1ffffffffff08dp-53])]);
(4%nat, [0; 0; 0; 0; 0; 0x7p-3; 0x7p-3; 0x7p-3; 0x7p-3; 0x7p-3; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (9%nat, 1, [0; 0; 0; 0; 1]);
  (9%nat, 0x7p-3, [1; 0; 0; 0; 0]);
  (9%nat, 0x39p-6, [0x961p-12; 0x157p-10; 0x93p-11; 0x7p-10; 0x1p-12]);
  (4%nat, 0x712fbf1569f85p-53, [0x13f72990ff7d89p-54; 0xd7fbe1d9f22edp-53; 0xdb0ba76d14a93p-54; 0x18aef2cc653c1bp-57; 0x10b058d912a0f9p-60]);
  (4%nat, -1, [1; 0; 0; 0; 0]);
  (9%nat, 0x1fffffffffffffp-53, [0x1p-200; 0x3ffffffffffffp-198; 0x5fffffffffffdp-148; 0x3fffffffffffdp-98; 0xffffffffffffp-48])]);
(4%nat, [0; 0; 0; 0; 0; 0x1p-960; 0x10000000000001p-1012; 0x8000000000001p-1011; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 0; 1]);
  (5%nat, 0x1p-960, [0xffffffffffffdp-208; 0x37fffffffffffp-151; 1; 0xffffffffffffdp-1012; 0]);
  (7%nat, 0xcb782006d70a5p-52, [0x1d0c43afeaee79p-62; 0x1c20c92f48217p-54; 0x28db25674c26dp-52; 0x1a5ff67de5b049p-54; 0xcc513a8d16c7fp-53]);
  (4%nat, -1, [1; 0; 0; 0; 0]);
  (7%nat, 0x3ffffffffffffp-50, [0x1p-200; 0x3ffffffffffffp-198; 0x5fffffffffffdp-148; 0x3fffffffffffdp-98; 0xffffffffffffp-48]);
  (4%nat, 0x1p-961, [0x1p-4; 0x8000000000001p-53; 0xc000000000001p-53; 0x13fffffffffffdp-54; 0xffffffffffffdp-1016]);
  (7%nat, 0x173c172a7bca9fp-53, [0x5c3b62df770f5p-58; 0x7a3e30b143d57p-55; 0x1e60e9a5448815p-55; 0x6b5e6bab03aadp-52; 0x239386b466771p-51])]);
(4%nat, [-0xbp-2; -0x9p-2; -0x3p-2; -0x1p-1; -0x1p-2; 0; 0x1p-1; 1; 0x3p-1; 0x3p-1; 0x3p-1; 0x9p-2],
 [(4%nat, -0x1p-2, [0x25ed097b425edp-55; 0x495ceb240795dp-51; 0x6333333333333p-52; 0x15555555555555p-58; 0]);
  (6%nat, 1, [0; 0x30c30c30c30c3p-54; 0x5041041041041p-52; 0x41c71c71c71c7p-51; 0x1p-3]);
  (5%nat, 0, [0x11111111111111p-55; 0x13333333333333p-53; 0x1075075075075p-50; 0x13813813813813p-59; 0]);
  (6%nat, 0xbp-4, [0xa6aaaaaaaaaabp-58; 0x12a58618618617p-54; 0x1027a082082081p-53; 0xc3c0e38e38e39p-54; 0x51p-15]);
  (5%nat, 0xb4ffef97e64b9p-54, [0x17d95f22873e9dp-58; 0x1a239169eec1dp-50; 0x7e1cd1a567e4fp-52; 0x264b6752b1103p-53; 0x38dd40e2bc181p-60]);
  (4%nat, -0x3p-1, [0x25ed097b425edp-55; 0x495ceb240795dp-51; 0x6333333333333p-52; 0x15555555555555p-58; 0]);
  (6%nat, 0x7ffffffffffffp-51, [0x11111111111111p-256; 0x1861861861863p-53; 0x1410410410410dp-54; 0x838e38e38e38dp-52; 0xffffffffffffp-51])]);
(4%nat, [0; 0; 0; 0; 0; 0x11p-537; 0x804376cb32fefp-583; 0x11p-536; 0x11450ec56d04cfp-584; 0x1p-531; 0x1p-531; 0x1p-531; 0x1p-531; 0x1p-531],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (8%nat, 0x1p-531, [0; 0; 0; 0; 1]);
  (7%nat, 0x11p-536, [0xdbc50954472b9p-65; 0x9c42ad61460b3p-52; 0x18be9f2c10187dp-54; 0xbbf7c62ef09dfp-60; 0]);
  (7%nat, 0x22450ec56d04dp-581, [0x1b78a12a88e3d9p-70; 0x4b62503b2f6a3p-51; 0xcffcdc3c98559p-53; 0x9e3eb7c3878c3p-59; 0xc32928f3cacabp-73]);
  (8%nat, 0xee673f92d0055p-583, [0x2501b2b3ec55bp-61; 0xaba011a4bd58dp-58; 0x3139294a269a5p-53; 0xbd26a93beb4e9p-53; 0x10c1e2b3a143ffp-53]);
  (4%nat, -0x1p-531, [1; 0; 0; 0; 0]);
  (8%nat, 0x7ffffffffffffp-582, [0x652e27c5543bdp-251; 0x949bca69d3b7bp-199; 0xde74326b8329fp-149; 0x8b089f8331fa1p-99; 0x1fffffffffffddp-53])]);
(4%nat, [0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0xee6b28011p-6; 0x1dcd65004021bbp-23; 0x773594011p-5; 0x1dcd650045143bp-23; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0],
 [(4%nat, 0x1dcd65p9, [1; 0; 0; 0; 0]);
  (8%nat, 0x3b9aca01p0, [0; 0; 0; 0; 1]);
  (7%nat, 0x773594011p-5, [0x1b78990edbf3fdp-66; 0x9c42ac3373b31p-52; 0x18be9f6d1c1193p-54; 0xbbf7f1d84fa75p-60; 0]);
  (7%nat, 0xee6b2802233cbp-22, [0x10c467d9ba93e7p-68; 0x2608ac4771e69p-50; 0xcd891283c3f77p-53; 0x8bdbb5edbac5bp-59; 0x1edfd58cc504f1p-76]);
  (4%nat, 0x1dcd65000fb55bp-23, [0x1571f5b5c6e1e7p-56; 0x83748472a2eddp-52; 0xa537104b2509dp-53; 0x12f867d14cfec3p-56; 0xc2caf05b564b7p-59]);
  (4%nat, 0x3b9ac9ffp0, [1; 0; 0; 0; 0])]);
(4%nat, [0; 0; 0; 0; 0; 0x1p-38; 0x23p-6; 0x15p-5; 0x3ffp-10; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (8%nat, 1, [0; 0; 0; 0; 1]);
  (8%nat, 0x3ffp-10, [0x19ae24ea557793p-80; 0x99c655cce7fa1p-67; 0x22bc22806ced5p-56; 0xfdd30a319f727p-52; 0]);
  (6%nat, 0x149p-9, [0x97b425ed0d17fp-71; 0x1ab716fb201a5p-52; 0x36a6d22bdf145p-51; 0x75ddc16ae2b0bp-52; 0x10eb825dd27607p-59]);
  (6%nat, 0x148dfa49314329p-53, [0x145ec0409f10c5p-72; 0x1aca0a56b5263dp-56; 0xdacbdfe311de3p-53; 0x75b811aed8297p-52; 0x217dfaa298093p-56]);
  (4%nat, -1, [1; 0; 0; 0; 0]);
  (8%nat, 0x7ffffffffffffp-51, [0x19ae24ea557793p-244; 0xcd712752a86dp-186; 0x45d1745d172e7p-138; 0x1fffffffffe7efp-92; 0x7fffffffffp-39])]);
(4%nat, [-1; -1; -1; -1; -1; -0; 0; 0x3p-6; 0x3p-5; 1; 1; 1; 1; 1],
 [(4%nat, -1, [1; 0; 0; 0; 0]);
  (8%nat, 1, [0; 0; 0; 0; 1]);
  (7%nat, 0x3p-6, [0xaf8af8af8af8bp-58; 0x7744ea0ea0ea1p-51; 0xe7p-12; 0x9p-13; 0]);
  (8%nat, 0x23p-6, [0x18fd1d60864b8bp-57; 0xe9a47b03188fbp-54; 0x64378d2d13a1fp-52; 0x1138315878c51bp-54; 0x1p-4]);
  (8%nat, 0xb47868ce7a6cfp-52, [0x8fb994fa38b8bp-58; 0xa8f7466033e3dp-55; 0x126c4cc086e855p-54; 0x1a7e46715d2031p-54; 0xd3df906201fa1p-54]);
  (4%nat, -3, [1; 0; 0; 0; 0]);
  (8%nat, 0x1ffffffffffff9p-53, [0xadbad39298877p-252; 0xc68c5f82f7761p-200; 0x551796a5d7c4dp-148; 0x1ee58469ee583p-97; 0xffffffffffff1p-52])]);
(2%nat, [0; 0; 0; 0x17p-6; 0x7faf4991a122bp-51; 1; 1; 1],
 [(2%nat, 0, [1; 0; 0]);
  (4%nat, 1, [0; 0; 1]);
  (4%nat, 0x7faf4991a122bp-51, [0x1f7f63443d63e7p-61; 0x7f820272ef0a7p-51; 0]);
  (3%nat, 0x4ca1bb969c6dp-47, [0x1ffca43a55bc1p-51; 0x138544db60299fp-53; 0x11ee4858299d75p-55]);
  (3%nat, 0x60ac551d066d7p-52, [0x1351327770d21p-49; 0x1950404d8fdef5p-54; 0xd5ac38e7ce995p-62]);
  (2%nat, -1, [1; 0; 0]);
  (4%nat, 0x1ffffffffffffbp-53, [0x1ef1a18ca6b0bbp-145; 0x3f6f57f9ef48dp-91; 0x1ffffffffff025p-53])]);
(2%nat, [0; 0; 0; 0xd28bc00df1dfp-49; 0x1fp-6; 0x14ceac98ef4c13p-53; 0xc0d46eb3af6adp-52; 1; 1; 1],
 [(2%nat, 0, [1; 0; 0]);
  (6%nat, 1, [0; 0; 1]);
  (6%nat, 0xc0d46eb3af6adp-52, [0xb49ab37bbe1ebp-52; 0x12d9532110785p-50; 0]);
  (4%nat, 0x9bd80b959bc87p-52, [0xb1a56e5128b37p-56; 0x138233e05c0e87p-53; 0x16350286034025p-54]);
  (6%nat, 0x1c3dde02778f7dp-53, [0x147503d1eaaaf5p-55; 0x90c8cad0e5ab3p-52; 0x232696c5a27f7p-51]);
  (2%nat, -1, [1; 0; 0]);
  (6%nat, 0x7ffffffffffffp-51, [0xb9615f77eeaddp-150; 0x81ae722a16fdp-95; 0x1fffffffffffdfp-53])]);
(2%nat, [0; 0; 0; 0x14275ea995f245p-56; 0x7p-3; 0x7p-3; 1; 1; 1],
 [(2%nat, 0, [1; 0; 0]);
  (5%nat, 1, [0; 0; 1]);
  (5%nat, 0x7p-3, [1; 0; 0]);
  (2%nat, 0x3c761bfcc1d6dp-55, [0x19p-6; 0x13185a192a216bp-53; 0x67a5e6d5de94dp-57]);
  (3%nat, 0x64fe196ed2d4fp-53, [0x1518c8bfcdc7c9p-53; 0xa31b61a3495f3p-53; 0x5ac092fed121fp-56]);
  (2%nat, -1, [1; 0; 0]);
  (5%nat, 0x3ffffffffffffp-50, [0x1p-94; 0x7fffffffffffp-93; 0x3fffffffffffp-46])]);
(2%nat, [0; 0; 0; 0x1p-960; 0x1p-960; 1; 1; 1],
 [(2%nat, 0, [1; 0; 0]);
  (4%nat, 1, [0; 0; 1]);
  (4%nat, 0x1p-960, [1; 0; 0]);
  (2%nat, 0x7p-963, [0x1p-6; 0x7p-5; 0x31p-6]);
  (4%nat, 0x901193f305cd3p-53, [0x10866bbed258cfp-53; 0x19e1ec07f52979p-54; 0x1444f1e99893a7p-56]);
  (2%nat, -1, [1; 0; 0]);
  (4%nat, 0x3ffffffffffffp-50, [0x1p-100; 0x3ffffffffffffp-99; 0x1ffffffffffffp-49])]);
(2%nat, [-4; -0xfp-2; 0x5p-2; 2; 0x9p-2; 0xdp-2],
 [(2%nat, 0x5p-2, [0x10b21642c8590bp-55; 0x1bd37a6f4de9bdp-53; 0]);
  (2%nat, 2, [0; 0x1p-2; 0x3p-2]);
  (2%nat, 0x1dp-4, [0x10b21642c8590bp-59; 0x48f4de9bd37a7p-51; 0x1bp-6]);
  (2%nat, 0x1e5498a2b32e8bp-52, [0x14aee5e2289883p-61; 0x7110072be59e7p-52; 0x11c95034a12399p-53]);
  (2%nat, 0x1p-1, [0x10b21642c8590bp-55; 0x1bd37a6f4de9bdp-53; 0]);
  (2%nat, 0x1ffffffffffffdp-52, [0x10b21642c8590bp-155; 0x2000000000003p-51; 0x5fffffffffffdp-51])]);
(2%nat, [0; 0; 0; 0x1p528; 0x1p531; 0x1p531; 0x1p531],
 [(2%nat, 0, [1; 0; 0]);
  (3%nat, 0x1p531, [0; 0; 1]);
  (3%nat, 0x1p528, [0x7p-3; 0x1p-3; 0]);
  (2%nat, 0x1p527, [0x1p-2; 0x17p-5; 0x1p-5]);
  (3%nat, 0x1f514f05993465p478, [0x11079464246f5fp-63; 0xc315f1daa8135p-56; 0x1e75923731a6bdp-53]);
  (2%nat, -0x1p531, [1; 0; 0]);
  (3%nat, 0x3ffffffffffffp481, [0x9249249249249p-151; 0x1249249249248dp-101; 0xffffffffffff7p-52])]);
(2%nat, [-0x1dcd65p9; -0x1dcd65p9; -0x1dcd65p9; -0x1dcd64fffp-3; -0x3b9ac9ffp0; -0x3b9ac9ffp0; -0x3b9ac9ffp0],
 [(2%nat, -0x1dcd65p9, [1; 0; 0]);
  (3%nat, -0x3b9ac9ffp0, [0; 0; 1]);
  (3%nat, -0x1dcd64fffp-3, [0x7p-3; 0x1p-3; 0]);
  (2%nat, -0x3b9ac9fffp-4, [0x1p-2; 0x17p-5; 0x1p-5]);
  (3%nat, -0x1dcd64ffedcc27p-23, [0x1ae8d926f5ae49p-53; 0x144fef44587343p-55; 0xcac1fd0d39783p-63]);
  (2%nat, -0x3b9aca01p0, [1; 0; 0])]);
(2%nat, [0; 0; 0; 0x1p-49; 0x13p-5; 0x39076ec56f2c1p-50; 0x3ffp-10; 1; 1; 1],
 [(2%nat, 0, [1; 0; 0]);
  (6%nat, 1, [0; 0; 1]);
  (3%nat, 0x1p-49, [0x1fffffffffffe5p-53; 0x35e50d79435e5p-98; 0]);
  (3%nat, 0x3900000000001p-51, [0x1fffffffffffe5p-57; 0x12019061255331p-53; 0x17fcdf3db559a1p-54]);
  (4%nat, 0x59743b5f72badp-51, [0x8ecdc9e140a6dp-54; 0xc4d3dc6daed63p-52; 0x2ef1623402003p-53]);
  (2%nat, -1, [1; 0; 0]);
  (6%nat, 0x3ffffffffffffp-50, [0x125ca3c72792e9p-139; 0x7fffffffffbf7p-90; 0x7fffffffffp-39])]);
(2%nat, [-1; -1; -1; -0; 0; 0x74e59faab3659p-53; 0x1abf29c91aef1fp-53; 1; 1; 1],
 [(2%nat, -1, [1; 0; 0]);
  (6%nat, 1, [0; 0; 1]);
  (6%nat, 0x1abf29c91aef1fp-53, [0x1b3ae7afefd7b9p-55; 0xc98a30a020509p-52; 0]);
  (6%nat, 0x3d5f94e48d779p-50, [0xd9d73d7f7ebd7p-58; 0xd93146140409fp-53; 0x9000000000001p-52]);
  (2%nat, -0x565394553927p-51, [0xe8e217963cdf5p-61; 0x14ac02fdb80ce1p-56; 0xeadf8bf67cd4bp-52]);
  (2%nat, -3, [1; 0; 0]);
  (6%nat, 0x1fffffffffffffp-53, [0x1f9322fc9c7cf1p-156; 0x185da3e782c45dp-102; 0x1ffffffffffff3p-53])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x9p-4; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (6%nat, 1, [0; 0; 0; 0; 0; 1]);
  (6%nat, 0x9p-4, [0x961p-16; 0xc0fp-14; 0x2e83p-15; 0x13efp-14; 0x19a1p-16; 0]);
  (6%nat, 0x6bp-7, [0x8e713p-31; 0x35d6f9p-29; 0x3f92e71p-30; 0x8f23191p-29; 0x472f99e3p-31; 0xc35p-15]);
  (6%nat, 0x17b0de5d51fb63p-53, [0x161a23ecc0fc1bp-61; 0x11eab95bec15f5p-57; 0x5942cce3f7663p-53; 0x66b550e6d1f27p-52; 0xc05783dc7ad5fp-53; 0x16bac75cc6e513p-59]);
  (5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (6%nat, 0x7ffffffffffffp-51, [0x9249249249249p-305; 0x16db6db6db6db3p-253; 0x16db6db6db6dbp-197; 0x16db6db6db6dabp-150; 0x5b6db6db6db69p-98; 0x1fffffffffffd3p-53])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x9p-5; 0xb0375b54fa6fp-49; 0x17p-6; 0x7p-4; 0x7p-4; 0x21p-6; 0x1728909baea489p-53; 0x1728909baea489p-53; 0x1728909baea489p-53; 0x1728909baea489p-53; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (15%nat, 1, [0; 0; 0; 0; 0; 1]);
  (6%nat, 0x9p-5, [0x926daf993607fp-61; 0xd8298aa0b5277p-57; 0x7ffff546d1847p-53; 0x1d5327cfbdc439p-54; 0x10ea38bc337a29p-54; 0]);
  (7%nat, 0x59914c8a8e42bp-52, [0x2f23fc8faae95p-69; 0xc205948cb09a1p-57; 0x77d1b7ccff08dp-53; 0xb02d867d169a3p-52; 0x6eca6d61a7177p-55; 0x1773a26373644bp-73]);
  (11%nat, 0xb8a5a972f47cbp-52, [0x138555bfc0f413p-87; 0x1d9981d24539ebp-78; 0x89bc41ba65c47p-68; 0x7da8a68cbe84fp-61; 0x13013bd1544df1p-53; 0xcf6d85de90c9bp-53]);
  (5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (15%nat, 0x1ffffffffffffbp-53, [0x87226841b5d9fp-296; 0x4174aa7fd4157p-243; 0x1cefbd5236dbp-188; 0xccacae495af71p-146; 0x5a7b6063203cdp-97; 0x1fffffffffffa5p-53])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x1p-1; 0x3p-2; 0x3p-2; 0x3p-2; 0x3p-2; 0x7p-3; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (11%nat, 1, [0; 0; 0; 0; 0; 1]);
  (11%nat, 0x7p-3, [0x1p-4; 0x1p-2; 0x3p-3; 0x1p-2; 0x1p-4; 0]);
  (10%nat, 0x19p-5, [0x51p-10; 0x2d67p-14; 0x5cfp-13; 0x39p-11; 0x11p-13; 0x1p-14]);
  (10%nat, 0xd1fd3f8d5b0b9p-52, [0x57df7e583d9ffp-58; 0x5cd562a91db71p-52; 0xcc41fbae98c99p-53; 0x302d274f0b43fp-52; 0x152e02a1b674e1p-57; 0x1cbf1cc9cde821p-61]);
  (5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (11%nat, 0xfffffffffffffp-52, [0x1p-249; 0x9fffffffffffdp-248; 0x4fffffffffffdp-196; 0x4fffffffffffbp-146; 0x9fffffffffff1p-98; 0x1fffffffffffbp-49])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x1p-1; 0x10000000000001p-53; 0x8000000000001p-52; 0x10000000000003p-53; 0x4000000000001p-51; 0x4000000000001p-51; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (11%nat, 1, [0; 0; 0; 0; 0; 1]);
  (7%nat, 0x10000000000001p-53, [0x7fffffffffffdp-208; 0x9aaaaaaaaaaa7p-153; 0x50aaaaaaaaaa9p-100; 0x1faaaaaaaaaaa1p-53; 0x15555555555555p-59; 0]);
  (6%nat, 0x1p-1, [0x3ffffffffffffp-258; 0x77ffffffffffdp-203; 0x63ffffffffffdp-150; 0x13fffffffffff5p-101; 0x7fffffffffffbp-51; 0]);
  (5%nat, 0x18b2412d4e8b1p-51, [0x165c9f5cc60dcdp-56; 0x464135c834f8bp-52; 0x5849dbfdc6de9p-52; 0xdde72032669d7p-54; 0x116dd072a310c5p-56; 0x1185b2f00b16d7p-59]);
  (5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (11%nat, 0x7ffffffffffffp-51, [0x8000000000007p-301; 0x1400000000000bp-250; 0x5000000000001p-197; 0x13fffffffffffbp-149; 0x13fffffffffff1p-100; 0x3fffffffffffbp-50])]);
(5%nat, [-0xdp-2; -0xdp-2; -0x5p-1; -0x9p-2; -0x9p-2; -0x1p-1; -0x1p-2; -0x1p-2; 0x1p-2; 1; 0x9p-2; 4],
 [(5%nat, -0x1p-1, [0x25ed097b425edp-62; 0xca4587e6b74fp-55; 0x14dc81f5a23251p-55; 0x11590ef755dbc5p-53; 0x12781f81f81f83p-54; 0]);
  (5%nat, -0x1p-2, [0; 0; 0xda740da740da7p-57; 0x3595bfc2628c9p-51; 0x1196bc547f7683p-53; 0xa57eb50295fadp-59]);
  (5%nat, -0x5p-4, [0x25ed097b425edp-72; 0x83f35ba781949p-66; 0xc419581d54527p-56; 0x1e54cac1c5b5f5p-54; 0x1e86a869fafcc7p-54; 0x13a2e8ba2e8ba3p-62]);
  (5%nat, -0x17606cb32d65e3p-54, [0x1947cb241e6c0dp-71; 0x16479dcc007f2dp-64; 0x12c061a6c08929p-56; 0x411a59d793477p-51; 0x1ab958cc0e3dcdp-54; 0xf0d4c7da7fb7bp-64]);
  (5%nat, -0x3p-2, [0x25ed097b425edp-62; 0xca4587e6b74fp-55; 0x14dc81f5a23251p-55; 0x11590ef755dbc5p-53; 0x12781f81f81f83p-54; 0]);
  (5%nat, -0x4000000000001p-52, [0x25ed097b425edp-312; 0x11c71c71c71c71p-259; 0xda740da740dbp-53; 0x6b2b7f84c5193p-52; 0x1196bc547f7681p-53; 0xa57eb50295fa1p-59])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x1p-531; 0x1p-531; 0x1p-531; 0x1p-531; 0x1p-531; 0x1p-531],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (5%nat, 0x1p-531, [0; 0; 0; 0; 0; 1]);
  (5%nat, 0x3p-533, [0x1p-10; 0xfp-10; 0x2dp-9; 0x87p-9; 0x195p-10; 0xf3p-10]);
  (5%nat, 0x7a26cc71f90bdp-583, [0x1401423b5fa349p-57; 0x16d225669f7c47p-55; 0xa69cda54725bbp-53; 0x4c06bb0d2854dp-52; 0x4561e6c7772ebp-53; 0x32a7c3cfa0de7p-55]);
  (5%nat, -0x1p-531, [1; 0; 0; 0; 0; 0]);
  (5%nat, 0x3ffffffffffffp-581, [0x1p-250; 0x13fffffffffffbp-250; 0x9fffffffffffbp-198; 0x13fffffffffff1p-149; 0x4fffffffffffbp-98; 0x3fffffffffffbp-50])]);
(5%nat, [-0x1dcd65p9; -0x1dcd65p9; -0x1dcd65p9; -0x1dcd65p9; -0x1dcd65p9; -0x1dcd65p9; -0x3b9ac9ffp0; -0x3b9ac9ffp0; -0x3b9ac9ffp0; -0x3b9ac9ffp0; -0x3b9ac9ffp0; -0x3b9ac9ffp0],
 [(5%nat, -0x1dcd65p9, [1; 0; 0; 0; 0; 0]);
  (5%nat, -0x3b9ac9ffp0, [0; 0; 0; 0; 0; 1]);
  (5%nat, -0xee6b27ffp-2, [0xf3p-10; 0x195p-10; 0x87p-9; 0x2dp-9; 0xfp-10; 0x1p-10]);
  (5%nat, -0x773593fe4851bp-21, [0x1d7a2401a21be3p-67; 0x1c00856503b3a5p-62; 0x1547d6a760a1c3p-58; 0x816169f86e8cdp-54; 0xc4a65ab2ddff7p-53; 0x1de3b449223c63p-54]);
  (5%nat, -0x3b9aca01p0, [1; 0; 0; 0; 0; 0])])].

Definition rows_1 : list (nat * list float * list (nat * float * list float)) := [
(5%nat, [0; 0; 0; 0; 0; 0; 0x1p-49; 0x1p-3; 0x5p-3; 0xffffffffffp-40; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (9%nat, 1, [0; 0; 0; 0; 0; 1]);
  (7%nat, 0x1p-3, [0xd1b71758e21a1p-53; 0xf117c1bda4d9fp-53; 0x1bc189374bdf7fp-56; 0x15eb851eb866a7p-59; 0xcccccccccd8ebp-63; 0]);
  (9%nat, 0x7fffffffff9p-43, [0x3205555555557p-209; 0x75e7ffffff6efp-168; 0x686155555439dp-127; 0x12000aaaaa53afp-89; 0xfffdfffff7p-40; 0x1p-15]);
  (8%nat, 0xee9e779ad9bb9p-52, [0x9387e8bce8d05p-69; 0x9a106a65f85d9p-63; 0x1fc2d334d3d7b3p-60; 0xcc1eb522e3efdp-55; 0x10c3e2999c5007p-53; 0x179356e28ca9b9p-54]);
  (5%nat, -1, [1; 0; 0; 0; 0; 0])]);
(5%nat, [-1; -1; -1; -1; -1; -1; -0; 0; 0x1p-6; 0x2fp-6; 1; 1; 1; 1; 1; 1],
 [(5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (9%nat, 1, [0; 0; 0; 0; 0; 1]);
  (9%nat, 0x2fp-6, [0xa5b75d75d75d7p-60; 0xef1b59b825aafp-56; 0x1d92f6deffe693p-55; 0x363fb0e82492bp-51; 0x918686f17db6dp-53; 0]);
  (7%nat, 0x1p-8, [0x1cfe99cddc9bddp-73; 0xb6a4a72e9b501p-54; 0x1107c04abf700bp-53; 0x128630f090285fp-54; 0x671e3f4693a4bp-74; 0x15c9882b931057p-86]);
  (8%nat, 0x3e43b158344bp-50, [0x1e70cd53f50eefp-56; 0x10110e46b8f665p-53; 0xc0ef395186ea9p-53; 0x11716adf9a6a15p-61; 0x1c9e43acafbe0bp-67; 0x95c1abeb450d9p-73]);
  (5%nat, -3, [1; 0; 0; 0; 0; 0]);
  (9%nat, 0x3ffffffffffffp-50, [0xf4c400f4c400fp-301; 0x4c7d404c7d403p-246; 0x131f50131f5003p-197; 0x263ea0263e9ffp-144; 0x9696969696953p-97; 0x1fffffffffff69p-53])]);
(4%nat, [0; 0; 0; 0; 0; 0x7p-5; 0xeb80702b72323p-53; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (6%nat, 1, [0; 0; 0; 0; 1]);
  (6%nat, 0xeb80702b72323p-53, [0x19cdd45d8506d3p-55; 0x3ab5813756efdp-51; 0x13dc1900794a5bp-54; 0x1e23c3518ba517p-58; 0]);
  (5%nat, 0x15b80702b72323p-54, [0x49d7b15dff6c5p-57; 0x1bd3d8ddf245abp-54; 0xdca3faee403c3p-53; 0x7e5d49e38284bp-54; 0xf11e1a8c5d28bp-61]);
  (4%nat, 0x9d86583c7abp-50, [0xd5dfc9b9fd59fp-52; 0xa3198123f805dp-54; 0x55e40f8d1714fp-58; 0x1222907425ff75p-67; 0x16cc1c39ad59dbp-76]);
  (4%nat, -1, [1; 0; 0; 0; 0]);
  (6%nat, 0xffffffffffffdp-52, [0x17ff97f74f91fbp-253; 0x1fff7549bf6d47p-201; 0xfffbaa4dfb69fp-149; 0x1638833a532847p-100; 0x7fffffffffff5p-51])]);
(4%nat, [0; 0; 0; 0; 0; 0x2b6e24734bp-41; 0x7p-6; 0xe72ca93ea855bp-53; 0x1188a49f309b25p-53; 0x27p-6; 0xade702875aa8fp-52; 0x31p-6; 0x35p-6; 0xdf5ab8e74b095p-52; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (13%nat, 1, [0; 0; 0; 0; 1]);
  (5%nat, 0x2b6e24734bp-41, [0x5ca445597528bp-57; 0x589233854cecbp-51; 0x118c10c61dad2bp-54; 0x5c633b223c8b3p-56; 0]);
  (11%nat, 0x19p-5, [0x8ac07a7c68a71p-58; 0x1ce04628c70f21p-55; 0x50b962bcb841bp-51; 0x8a5c198f4cf39p-54; 0x154bce78fdb5a7p-65]);
  (9%nat, 0x145b630d7eb6e3p-53, [0x17cfb50d59cd13p-61; 0x90ab5c695e8b3p-53; 0x130a2dc0f1b767p-53; 0x1e64cb72fab035p-56; 0x1acd542ec0494fp-63]);
  (4%nat, -1, [1; 0; 0; 0; 0]);
  (13%nat, 0xfffffffffffffp-52, [0x4be087547d905p-249; 0x61554e19a08dbp-197; 0x88dff5d409c7p-143; 0x7d77f6ad08f63p-98; 0x1fffffffffffc1p-53])]);
(4%nat, [0; 0; 0; 0; 0; 0x1p-3; 0x3p-3; 0x3p-3; 0x3p-3; 0x3p-3; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (9%nat, 1, [0; 0; 0; 0; 1]);
  (9%nat, 0x3p-3, [1; 0; 0; 0; 0]);
  (5%nat, 0x9p-5, [0x3p-9; 0x45p-10; 0x243p-11; 0x7ddp-12; 0x271p-12]);
  (5%nat, 0xb9f40a5a0b045p-53, [0x18c19978f63d85p-72; 0x17b1d430402e6dp-65; 0x10f6826d1f19fp-55; 0x15715c4e30c5dfp-55; 0x1a5e50ad491effp-53]);
  (4%nat, -1, [1; 0; 0; 0; 0]);
  (9%nat, 0x1ffffffffffff9p-53, [0xf5dcc63f14121p-250; 0xaf9db22d0e55dp-198; 0xbc28f5c28f5bbp-148; 0x1666666666665p-96; 0x7fffffffffff5p-51])]);
(4%nat, [0; 0; 0; 0; 0; 0x1p-960; 0x10000000000001p-1012; 0x8000000000001p-1011; 0x10000000000003p-1012; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (8%nat, 1, [0; 0; 0; 0; 1]);
  (7%nat, 0x8000000000001p-1011, [0x15555555555551p-107; 0x1fffffffffffffp-53; 0x11555555555555p-1063; 0; 0]);
  (8%nat, 0x67f9b9ca31e9p-48, [0x1fd6512c63ed69p-56; 0x5719476c8f2c7p-52; 0x1656bdf6e27e39p-54; 0x517c1c51ce5e9p-53; 0x1bdd858a6ef7f3p-58]);
  (4%nat, -1, [1; 0; 0; 0; 0]);
  (8%nat, 0x3ffffffffffffp-50, [0x1p-200; 0x3ffffffffffffp-198; 0x5fffffffffffdp-148; 0x3fffffffffffdp-98; 0xffffffffffffp-48])]);
(4%nat, [-4; -4; -0xdp-2; -3; -0x1p-2; 0; 0x3p-2; 0x5p-2; 0x5p-2; 0x3p-1; 0x7p-2; 3; 3; 0xdp-2],
 [(4%nat, -0x1p-2, [0xd20d20d20d20dp-63; 0xb0d90d90d90d9p-55; 0xf4e12ff4e12ffp-53; 0x6f5a04af5a04bp-52; 0]);
  (8%nat, 0x3p-1, [0; 0x1p-4; 0x31397829cbc15p-50; 0x143eb1a1f58d1p-51; 0x14e5e0a72f0539p-59]);
  (8%nat, 0x5p-2, [0x71c71c71c71c7p-55; 0x4e38e38e38e39p-51; 0x15555555555555p-54; 0; 0]);
  (5%nat, 0x3p-4, [0x12399999999999p-59; 0xf585555555555p-54; 0x1617f012345679p-53; 0xf69e26af37c05p-56; 0x5c28f5c28f5c3p-61]);
  (8%nat, 0xa63222f9ec4bdp-51, [0x180dce4b3f7e33p-58; 0x40216dd28d017p-51; 0x1e4f256ece03e1p-54; 0x1f0a9cc9e0209p-58; 0xf099b68d88d45p-68]);
  (4%nat, -2, [0xd20d20d20d20dp-63; 0xb0d90d90d90d9p-55; 0xf4e12ff4e12ffp-53; 0x6f5a04af5a04bp-52; 0]);
  (8%nat, 0xbfffffffffffdp-51, [0x9p-197; 0x800000000003p-51; 0xc4e5e0a72f057p-52; 0x143eb1a1f58ccdp-55; 0x5397829cbc12fp-57])]);
(4%nat, [0; 0; 0; 0; 0; 0x31p-537; 0x1p-531; 0x1p-531; 0x1p-531; 0x1p-531; 0x1p-531],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (5%nat, 0x1p-531, [0; 0; 0; 0; 1]);
  (5%nat, 0x31p-537, [0xd2fp-18; 0x8133p-18; 0x1a60dp-18; 0x1cb91p-18; 0]);
  (5%nat, 0x1d3p-540, [0x42bdfp-30; 0x9f8823p-30; 0x87e5c1dp-30; 0x2d19efe1p-30; 0x271p-12]);
  (4%nat, 0xe89575aebdca3p-584, [0x700865b1323cfp-56; 0x8604bb42e6e1p-49; 0x67afef750b869p-52; 0x200811728f7d1p-51; 0x1c7a13529dd5fbp-57]);
  (4%nat, -0x1p-531, [1; 0; 0; 0; 0]);
  (5%nat, 0xfffffffffffffp-583, [0x11111111111111p-258; 0x1111111111110fp-204; 0xcccccccccccc9p-151; 0x2222222222221p-97; 0x1fffffffffffddp-53])]);
(4%nat, [0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0xee6b28031p-6; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0],
 [(4%nat, 0x1dcd65p9, [1; 0; 0; 0; 0]);
  (5%nat, 0x3b9aca01p0, [0; 0; 0; 0; 1]);
  (5%nat, 0xee6b28031p-6, [0xd2fp-18; 0x8133p-18; 0x1a60dp-18; 0x1cb91p-18; 0]);
  (4%nat, 0x7735940031p-9, [0x961p-12; 0x1689d42fp-30; 0x3ad1333p-30; 0x434d0dp-30; 0xe5c87ffffffffp-65]);
  (5%nat, 0x1dcd65006f9bf3p-23, [0x4b2f6375dd7d1p-60; 0xe146c49421e3p-53; 0x1d5a7425c1bf37p-55; 0x1663ca23de2fe9p-53; 0x15aec21ae82b5fp-57]);
  (4%nat, 0x3b9ac9ffp0, [1; 0; 0; 0; 0])]);
(4%nat, [0; 0; 0; 0; 0; 0x1p-108; 0x1p-2; 0xc7179f684b70dp-53; 0xfffp-12; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (8%nat, 1, [0; 0; 0; 0; 1]);
  (8%nat, 0xfffp-12, [0x22e8307899f1bp-84; 0x1a2bfa161de89dp-74; 0x4e7bd9fcea5abp-60; 0xffb17d9ae1a7fp-52; 0]);
  (8%nat, 0x7ffdp-15, [0x1616eeac516af1p-93; 0x1ab05bb098a50dp-78; 0x1114ced2877a87p-64; 0x1b1bdd58cd6b21p-53; 0x271p-12]);
  (7%nat, 0x16ef202c8c3d0fp-53, [0x72e23a7a98991p-57; 0x1073862a49b8b1p-55; 0x34bc08b7e825dp-51; 0xb9a9fc27959b3p-53; 0x1534d253fcb0a9p-56]);
  (4%nat, -1, [1; 0; 0; 0; 0])]);
(4%nat, [-1; -1; -1; -1; -1; -0; 0; 0x64114d4454887p-51; 0x7p-3; 1; 1; 1; 1; 1],
 [(4%nat, -1, [1; 0; 0; 0; 0]);
  (8%nat, 1, [0; 0; 0; 0; 1]);
  (6%nat, -0, [0x18a442c9a032a3p-55; 0x2085b45e7ac05p-50; 0x994151e5a932fp-53; 0; 0]);
  (6%nat, 0x64114d4454887p-54, [0x738e4b3283bd7p-54; 0xea640ca797357p-53; 0x1b28ab233075bp-50; 0x13efda6dc22c7p-56; 0x45e55fabe2cafp-63]);
  (4%nat, -0x6edd025a44803p-52, [0x120201ac49fbp-49; 0x5e4cc1640f4e3p-53; 0x10a461e4e63b6dp-53; 0x7595dd3f627p-45; 0xfd54161e08fffp-57]);
  (4%nat, -3, [1; 0; 0; 0; 0]);
  (8%nat, 0x3ffffffffffffp-50, [0x92a3c138ec093p-246; 0x125478271d8115p-195; 0xdbf5a1d5620bdp-144; 0x1fffffffffff69p-98; 0x1fffffffffffp-45])]);
(1%nat, [0; 0; 0x168170e6a165c9p-57; 1; 1],
 [(1%nat, 0, [1; 0]);
  (2%nat, 1, [0; 1]);
  (2%nat, 0x168170e6a165c9p-57, [1; 0]);
  (2%nat, 0x85a05c39a8597p-52, [0x1fffffffffffffp-54; 0xfffffffffffffp-53]);
  (2%nat, 0xd1ba775acc659p-53, [0x13c2b53e276be3p-53; 0x30f52b0762507p-51]);
  (1%nat, -1, [1; 0]);
  (2%nat, 0x3ffffffffffffp-50, [0x10bc52b12e9b5fp-102; 0x3ffffffffffffp-50])]);
(1%nat, [0; 0; 0x7p-5; 0xd32836fa8ae1p-48; 0x3dp-6; 0x3e999bb7bf03dp-50; 1; 1],
 [(1%nat, 0, [1; 0]);
  (5%nat, 1, [0; 1]);
  (5%nat, 0x3e999bb7bf03dp-50, [1; 0]);
  (4%nat, 0xf8ccd3273d0b7p-52, [0x1p-2; 0x3p-2]);
  (2%nat, 0x96edcbe0b1031p-52, [0x18d7de7d467b29p-54; 0x4e5043057309bp-51]);
  (1%nat, -1, [1; 0])]);
(1%nat, [0; 0; 0x1a7a52fd7075e7p-53; 0x1a7a52fd7075e7p-53; 1; 1],
 [(1%nat, 0, [1; 0]);
  (3%nat, 1, [0; 1]);
  (3%nat, 0x1a7a52fd7075e7p-53, [1; 0]);
  (1%nat, 0x13dbbe3e14586dp-53, [0x10000000000001p-54; 0x3p-2]);
  (1%nat, 0xeabc3c297d85p-50, [0x1722783dbefe8bp-53; 0x8dd87c2410175p-53]);
  (1%nat, -1, [1; 0]);
  (3%nat, 0x3ffffffffffffp-50, [0x172de5dda1d753p-100; 0x1fffffffffffd1p-53])]);
(1%nat, [0; 0; 0x1ffffffffffffdp-53; 0x1ffffffffffffdp-53; 0xfffffffffffffp-52; 1; 1],
 [(1%nat, 0, [1; 0]);
  (4%nat, 1, [0; 1]);
  (4%nat, 0xfffffffffffffp-52, [1; 0]);
  (4%nat, 0x1fffffffffffffp-53, [0x1p-1; 0x1p-1]);
  (1%nat, 0x96e23e1cfc9c3p-53, [0x1691dc1e30363dp-53; 0x25b88f873f271p-51]);
  (1%nat, -1, [1; 0])]);
(1%nat, [-4; -0xdp-2; -0x5p-1; -0x7p-2; -0x3p-1; -0x3p-2],
 [(1%nat, -0xdp-2, [1; 0]);
  (3%nat, -0x3p-1, [0; 1]);
  (3%nat, -0x7p-2, [1; 0]);
  (2%nat, -0x11p-3, [0x1p-1; 0x1p-1]);
  (2%nat, -0x8b1f2c6d2d4fbp-50, [0x90a6424646fe5p-52; 0xdeb37b7372035p-53]);
  (1%nat, -5, [1; 0]);
  (3%nat, -0x6000000000001p-50, [0x1p-48; 0xffffffffffffp-48])]);
(1%nat, [0; 0; 0x25p525; 0x1b0c3183c86443p478; 0xe0e608cee3d19p479; 0x1f8125e2add869p478; 0x1p531; 0x1p531],
 [(1%nat, 0, [1; 0]);
  (5%nat, 0x1p531, [0; 1]);
  (2%nat, 0x25p525, [1; 0]);
  (5%nat, 0x1fa0dc6a02624fp478, [0x17fffffffffff1p-53; 0x10000000000021p-54]);
  (2%nat, 0x140aa8fdbf3ec9p478, [0xd1d4000d44b15p-52; 0x1715fff95da75bp-55]);
  (1%nat, -0x1p531, [1; 0])]);
(1%nat, [-0x1dcd65p9; -0x1dcd65p9; -0xee6b27fdbp-6; -0xee6b27fc9e79dp-22; -0x773593fe3e33fp-21; -0x3b9ac9ff03f6dp-20; -0x3b9ac9ffp0; -0x3b9ac9ffp0],
 [(1%nat, -0x1dcd65p9, [1; 0]);
  (5%nat, -0x3b9ac9ffp0, [0; 1]);
  (4%nat, -0x773593fe3e33fp-21, [1; 0]);
  (4%nat, -0xee6b27fc46219p-22, [0x1fffffffffffffp-54; 0x1fffffffffffffp-54]);
  (1%nat, -0x1dcd64ffccdffdp-23, [0x13c8a3759f2299p-54; 0x586eb914c1badp-51]);
  (1%nat, -0x3b9aca01p0, [1; 0])]);
(1%nat, [0; 0; 0x1p-44; 0x2bp-6; 0x2dp-6; 0x1ffffffffp-33; 1; 1],
 [(1%nat, 0, [1; 0]);
  (5%nat, 1, [0; 1]);
  (2%nat, 0x1p-44, [1; 0]);
  (2%nat, 0x35c000000003p-47, [0x3p-3; 0x5p-3]);
  (2%nat, 0xe98e012e7655p-49, [0xa46239c6c10ddp-53; 0x15b9dc6393ef23p-53]);
  (1%nat, -1, [1; 0]);
  (5%nat, 0x3ffffffffffffp-50, [0x1p-17; 0x1ffffp-17])]);
(1%nat, [-1; -1; -0; 0; 0x32491f0c35f51p-52; 0x170ab6db20250fp-54; 1; 1],
 [(1%nat, -1, [1; 0]);
  (5%nat, 1, [0; 1]);
  (3%nat, -0, [1; 0]);
  (5%nat, 0x570ab6db20251p-51, [0x1p-1; 0x10000000000001p-53]);
  (4%nat, 0x4ebc6a4c0343fp-52, [0x148651f1e20f39p-54; 0x15bcd7070ef863p-53]);
  (1%nat, -3, [1; 0]);
  (5%nat, 0x1ffffffffffffbp-53, [0x1f405ca3208fffp-103; 0x3ffffffffffffp-50])]);
(2%nat, [0; 0; 0; 0x125a22f7abb297p-53; 0x1482bb7644bc6fp-53; 0x1dp-5; 1; 1; 1],
 [(2%nat, 0, [1; 0; 0]);
  (5%nat, 1, [0; 0; 1]);
  (3%nat, 0x125a22f7abb297p-53, [0x1af11dbef2d2bfp-56; 0x3943b890434b5p-50; 0]);
  (2%nat, 0x125a22f7abb297p-54, [0x1p-2; 0x86bc476fbcb4bp-52; 0x3943b890434b5p-52]);
  (2%nat, 0x648b95dac68a3p-53, [0x1bacaf0291560fp-54; 0xece3be909ff9p-49; 0x6b6d92b5aaad1p-54]);
  (2%nat, -1, [1; 0; 0]);
  (5%nat, 0x3ffffffffffffp-50, [0xedab7b739e27p-143; 0x15555555555531p-98; 0x1fffffffffff55p-53])]);
(2%nat, [0; 0; 0; 0x1p-5; 0xbp-6; 0xbp-6; 0xdp-6; 0x11dc1a10725d1p-49; 0x17p-5; 0x1d6d274484ac0bp-53; 1; 1; 1],
 [(2%nat, 0, [1; 0; 0]);
  (9%nat, 1, [0; 0; 1]);
  (5%nat, 0xbp-6, [1; 0; 0]);
  (2%nat, 0x5p-8, [0x9p-6; 0xc9d1745d1745dp-52; 0x91745d1745d17p-55]);
  (7%nat, 0x1657530967cfb3p-53, [0x14f754eb8d07f3p-60; 0x1507047ebf8109p-53; 0xacf0cd76964e7p-53]);
  (2%nat, -1, [1; 0; 0]);
  (9%nat, 0x3ffffffffffffp-50, [0x161ac888be792bp-147; 0xc6f10cceb240fp-97; 0xfffffffffff9dp-52])]);
(2%nat, [0; 0; 0; 0x1p-1; 0xf5618a421144fp-52; 0x1f727942807205p-53; 1; 1; 1],
 [(2%nat, 0, [1; 0; 0]);
  (5%nat, 1, [0; 0; 1]);
  (3%nat, 0x1p-1, [0x1e9d7cb757b839p-54; 0x10b141a45423e3p-53; 0]);
  (5%nat, 0xfe576bc781561p-52, [0x1dfcbd174420efp-57; 0x2340685d177bdp-50; 0xc800000000009p-53]);
  (5%nat, 0xff2160aa70449p-52, [0x107d1e2a1d3e85p-58; 0x2b5396bd0317p-47; 0x529cc57db9413p-51]);
  (2%nat, -1, [1; 0; 0])]);
(2%nat, [0; 0; 0; 0x14431670d7e0bbp-53; 0x14431670d7e0bbp-53; 0x510c59c35f82fp-51; 0x14431670d7e0bdp-53; 1; 1; 1],
 [(2%nat, 0, [1; 0; 0]);
  (6%nat, 1, [0; 0; 1]);
  (5%nat, 0x510c59c35f82fp-51, [0x1p-1; 0x1p-1; 0]);
  (6%nat, 0x3d10c59c35f83p-50, [0x1fffffffffffedp-59; 0xdfffffffffffdp-54; 0xc400000000001p-52]);
  (6%nat, 0x1e209e6491e63bp-53, [0xd07dd67e0ed75p-57; 0x11299888872d4dp-54; 0x169ab5e53e5a83p-53]);
  (2%nat, -1, [1; 0; 0]);
  (6%nat, 0x1ffffffffffffdp-53, [0x10b8efab3b0b2fp-152; 0x82db94063b007p-100; 0x1ffffffffffffp-49])]);
(2%nat, [-0xbp-2; -0x5p-1; -0x1p-1; 0x3p-2; 0x3p-1; 0x7p-2; 0x7p-1],
 [(2%nat, -0x1p-1, [0x189d89d89d89d9p-54; 0x4ec4ec4ec4ec5p-51; 0]);
  (3%nat, 0x3p-1, [0; 0x1p-2; 0x3p-2]);
  (3%nat, 0x3p-2, [0x3p-3; 0x5p-3; 0]);
  (3%nat, 0x1bp-5, [0x93p-9; 0x167p-9; 0x3p-8]);
  (2%nat, -0x1e41f1a0d7e17p-51, [0x7a9f77ce9e077p-53; 0x5dc94b01402c9p-51; 0x38ed70b185195p-55]);
  (2%nat, -0x5p-1, [0x189d89d89d89d9p-54; 0x4ec4ec4ec4ec5p-51; 0]);
  (3%nat, 0x17fffffffffffdp-52, [0x3p-103; 0x2000000000003p-51; 0x5fffffffffffdp-51])]);
(2%nat, [0; 0; 0; 0x1p531; 0x1p531; 0x1p531],
 [(2%nat, 0, [1; 0; 0]);
  (2%nat, 0x1p531, [0; 0; 1]);
  (2%nat, 0x5p528, [0x9p-6; 0xfp-5; 0x19p-6]);
  (2%nat, 0x40b7a36eb68b7p479, [0x4776874a7f67p-47; 0x305b4dfc4aa69p-51; 0x82e2ab935f27p-51]);
  (2%nat, -0x1p531, [1; 0; 0]);
  (2%nat, 0x3ffffffffffffp481, [0x1p-100; 0x3ffffffffffffp-99; 0x1ffffffffffffp-49])]);
(2%nat, [-0x1dcd65p9; -0x1dcd65p9; -0x1dcd65p9; -0x3b9ac9ffp0; -0x3b9ac9ffp0; -0x3b9ac9ffp0],
 [(2%nat, -0x1dcd65p9, [1; 0; 0]);
  (2%nat, -0x3b9ac9ffp0, [0; 0; 1]);
  (2%nat, -0x1dcd64ff9p-3, [0x1p-6; 0x7p-5; 0x31p-6]);
  (2%nat, -0x773593feccbbp-17, [0xa3ba9099p-34; 0xf5bb6f67p-33; 0x170ce9099p-34]);
  (2%nat, -0x3b9aca01p0, [1; 0; 0])]);
(2%nat, [0; 0; 0; 0x1p-200; 0x1p-5; 0x39p-6; 0x3ffffffp-26; 1; 1; 1],
 [(2%nat, 0, [1; 0; 0]);
  (6%nat, 1, [0; 0; 1]);
  (3%nat, 0x1p-200, [1; 0x1p-195; 0]);
  (4%nat, 0x47p-9, [0x17a3ee08fb823fp-53; 0xfd50b279cd415p-54; 0x1c6318cd84eda1p-59]);
  (4%nat, 0x5e087b3f7a06fp-51, [0x104715b8cda421p-57; 0x2fdce58129501p-51; 0x1304554428d1b9p-53]);
  (2%nat, -1, [1; 0; 0]);
  (6%nat, 0x3ffffffffffffp-50, [0x9249249249249p-122; 0x1fffffefffffdbp-76; 0xfffffe000001p-48])]);
(2%nat, [-1; -1; -1; -0; 0; 0x131c84950ee1a5p-57; 0xdp-6; 1; 1; 1],
 [(2%nat, -1, [1; 0; 0]);
  (6%nat, 1, [0; 0; 1]);
  (5%nat, 0x131c84950ee1a5p-57, [0xd0f4e1073dd49p-52; 0x17858f7c6115b7p-55; 0]);
  (6%nat, 0x67p-8, [0x1dccc21e3390b3p-54; 0x1e333de1cc6f4dp-54; 0x1p-4]);
  (6%nat, 0x6d43874a02387p-52, [0x1b68e7cfa02185p-54; 0x1f8c1d2f77e5p-46; 0xa15f601cff2f5p-55]);
  (2%nat, -3, [1; 0; 0]);
  (6%nat, 0xffffffffffffdp-52, [0x1776cdcc63432fp-153; 0x1e1e1e1e1e1e17p-102; 0x1ffffffffffffp-49])]);
(1%nat, [0; 0; 0x9p-5; 0x3p-3; 1; 1],
 [(1%nat, 0, [1; 0]);
  (3%nat, 1, [0; 1]);
  (2%nat, 0x9p-5, [1; 0]);
  (1%nat, 0x1bp-7, [0x1p-2; 0x3p-2]);
  (1%nat, 0xa74e2a3f11a5p-51, [0x16b48be00d3df1p-53; 0x4a5ba0ff96107p-52]);
  (1%nat, -1, [1; 0]);
  (3%nat, 0x3ffffffffffffp-50, [0xccccccccccccdp-101; 0x7fffffffffffdp-51])]);
(1%nat, [0; 0; 0x19p-6; 1; 1],
 [(1%nat, 0, [1; 0]);
  (2%nat, 1, [0; 1]);
  (2%nat, 0x19p-6, [1; 0]);
  (1%nat, 0x4bp-8, [0x1p-2; 0x3p-2]);
  (2%nat, 0x143f922429ac4fp-53, [0x4d23a32ce1535p-51; 0x32dc5cd31eacbp-51]);
  (1%nat, -1, [1; 0]);
  (2%nat, 0x3ffffffffffffp-50, [0xd20d20d20d20dp-101; 0x1ffffffffffff3p-53])]);
(1%nat, [0; 0; 0x1p-3; 0x3p-3; 1; 1],
 [(1%nat, 0, [1; 0]);
  (3%nat, 1, [0; 1]);
  (2%nat, 0x1p-3, [1; 0]);
  (1%nat, 0x3p-6, [0x5p-3; 0x3p-3]);
  (2%nat, 0x9e978cc6ce7bbp-53, [0x2168733931845p-51; 0x5e978cc6ce7bbp-51]);
  (1%nat, -1, [1; 0]);
  (3%nat, 0x3ffffffffffffp-50, [0xccccccccccccdp-101; 0x7fffffffffffdp-51])]);
(1%nat, [0; 0; 0x7fe44848c4fbfp-52; 0x7fe44848c4fbfp-52; 1; 1],
 [(1%nat, 0, [1; 0]);
  (3%nat, 1, [0; 1]);
  (3%nat, 0x7fe44848c4fbfp-52, [1; 0]);
  (1%nat, 0x7fe44848c4fbfp-53, [0x1p-1; 0x1p-1]);
  (1%nat, 0x68a2c329d05bbp-52, [0x5d1a3da59e045p-53; 0x68b97096987efp-51]);
  (1%nat, -1, [1; 0]);
  (3%nat, 0x3ffffffffffffp-50, [0x1ff91392006161p-102; 0x1ffffffffffffp-49])]);
(1%nat, [-0xbp-2; -0x1p-1; 0x3p-1; 2],
 [(1%nat, -0x1p-1, [1; 0]);
  (1%nat, 0x3p-1, [0; 1]);
  (1%nat, 0x3p-2, [0x3p-3; 0x5p-3]);
  (1%nat, 0x144b9566543b1fp-52, [0x3b46a99abc4e1p-53; 0x1c4b9566543b1fp-53]);
  (1%nat, -0x5p-1, [1; 0]);
  (1%nat, 0x2ffffffffffffp-49, [0x1p-50; 0x3ffffffffffffp-50])]);
(1%nat, [0; 0; 0x24167f0621e31p481; 0x1846747256ce87p478; 0x1846747256ce87p478; 0x1p531; 0x1p531],
 [(1%nat, 0, [1; 0]);
  (4%nat, 0x1p531, [0; 1]);
  (2%nat, 0x24167f0621e31p481, [1; 0]);
  (1%nat, 0x24167f0621e31p478, [0x7p-3; 0x1p-3]);
  (1%nat, 0xdd72de34fb56bp478, [0x1dd1697984593p-51; 0x622e96867ba6dp-51]);
  (1%nat, -0x1p531, [1; 0]);
  (4%nat, 0x3ffffffffffffp481, [0x1091ee13fe60d9p-100; 0xfffffffffffefp-52])]);
(1%nat, [-0x1dcd65p9; -0x1dcd65p9; -0xee6b27fdbe981p-22; -0xee6b27fcf7317p-22; -0xee6b27fcf7317p-22; -0x3b9ac9ffp0; -0x3b9ac9ffp0],
 [(1%nat, -0x1dcd65p9, [1; 0]);
  (4%nat, -0x3b9ac9ffp0, [0; 1]);
  (2%nat, -0xee6b27fdbe981p-22, [1; 0]);
  (4%nat, -0x773593fe1ee63p-21, [0x100001091ee315p-54; 0xbffffbdb8473bp-52]);
  (1%nat, -0x1dcd64ffc74d0fp-23, [0xdb93f44b6cfa7p-54; 0x1923605da4982dp-53]);
  (1%nat, -0x3b9aca01p0, [1; 0])]);
(1%nat, [0; 0; 0x1p-60; 0x23p-6; 0x5p-3; 0x3fffffffp-30; 1; 1],
 [(1%nat, 0, [1; 0]);
  (5%nat, 1, [0; 1]);
  (4%nat, 0x5p-3, [1; 0]);
  (5%nat, 0x1fffffffdp-33, [0x3p-3; 0x5p-3]);
  (2%nat, 0x2c5abbf38a7p-51, [0x1febb943adec99p-53; 0x1446bc52136663p-61]);
  (1%nat, -1, [1; 0])]);
(1%nat, [-1; -1; -0; 0; 0x7p-5; 0x1d77b375347311p-53; 1; 1],
 [(1%nat, -1, [1; 0]);
  (5%nat, 1, [0; 1]);
  (3%nat, -0, [1; 0]);
  (5%nat, 0x1dc8bd068de4afp-53, [0xdffffffffffffp-52; 0x8000000000003p-54]);
  (5%nat, 0x1e33001613a97p-49, [0x2d82845e8437bp-50; 0x127d7ba17bc84fp-54]);
  (1%nat, -3, [1; 0]);
  (5%nat, 0x1fffffffffffffp-53, [0x6516d320a5d35p-100; 0x1ffffffffffff3p-53])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x1f9cebb040a5d3p-55; 0xb1538ab5f0c43p-53; 0x25p-6; 0x179471a610985p-49; 0x35f7f7714c7d7p-50; 0x3bp-6; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (12%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (8%nat, 0xb1538ab5f0c43p-53, [0x94266bee50df1p-57; 0xd4fc853c98a41p-54; 0x1b71afe2c9c13dp-54; 0x2473aaaa2b0f5p-51; 0x7b25672c647ffp-55; 0xce98c5d9c6e1bp-64; 0]);
  (10%nat, 0xc372a155b00f5p-52, [0x16c4356f69815p-63; 0x11081559f1dafdp-59; 0x136c2a92dab6cfp-55; 0x1b9f30221a0059p-54; 0x17be7bfaa71175p-54; 0x1319c0850d895bp-57; 0x1f7969aefb702bp-71]);
  (11%nat, 0xdb72e6ef22749p-52, [0xab1c5c928bec5p-66; 0xc6e3bce9dd133p-58; 0x11740fbcd1eb65p-55; 0xf085ab2965d81p-53; 0x165e0bfa0a2c3p-50; 0x41f4776eb5a09p-55; 0x216d2033b4747p-69]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (12%nat, 0xfffffffffffffp-52, [0xbad232559d963p-353; 0xd30562f491ef1p-299; 0x5635bed086949p-245; 0x60fc76aa9766fp-194; 0x1323d2f63df419p-146; 0x999999999997dp-97; 0xfffffffffffb5p-52])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x2dp-6; 0x1bef6c18f5380fp-53; 0x1bef6c18f5380fp-53; 0x1bef6c18f5380fp-53; 0x1bef6c18f5380fp-53; 0x1bef6c18f5380fp-53; 0x1e2ece76b65c31p-53; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (13%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (7%nat, 0x2dp-6, [0x922f56184c857p-63; 0x2f4715ab4589bp-57; 0xc3b686407c761p-56; 0x6545dbf8d2fcbp-53; 0xd19dfb2434651p-53; 0xad8c5aeaaea3bp-53; 0]);
  (7%nat, 0x326f6c18f5381p-50, [0x1245eac309909bp-70; 0xeb6e72afc04fbp-64; 0x267b64977d929p-57; 0xcd82342b17e91p-56; 0x11b74f1bf99a61p-54; 0xa83356b97553p-48; 0xb51b9c18340f7p-58]);
  (6%nat, 0x4029b1019110dp-53, [0x276b64a72f4d7p-51; 0x3905eb50e804bp-51; 0x190bb44d662bcbp-55; 0x16ebbfd154a68dp-57; 0x176100834f5fbp-56; 0x19513a7ef332dp-60; 0x16c934d8f68043p-69]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (13%nat, 0xfffffffffffffp-52, [0x82024dabcbf99p-344; 0x318aeb44b1e03p-291; 0x1f772742684b19p-244; 0x2aa2146fb8d37p-191; 0x81f84f6d3d4e7p-144; 0xd3518a38c5763p-97; 0x1fffffffffff31p-53])])].

Definition rows_2 : list (nat * list float * list (nat * float * list float)) := [
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x1p-1; 0x7p-3; 0x7p-3; 0x7p-3; 0x7p-3; 0x7p-3; 0xe76513f411bf5p-52; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (13%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (12%nat, 0x7p-3, [0x124f2880a4b607p-56; 0x1db61aefeb693fp-53; 0; 0; 0; 0; 0]);
  (12%nat, 0x38b179dee1a9fp-50, [0x45d816f13c51fp-58; 0x5dcbd4b2aeb0bp-51; 0xe79d8ce2cb58dp-54; 0x8b213af43c5d7p-56; 0x1605d173ad3f35p-61; 0xe64183399d2dfp-65; 0x1ebf2fda7d5df5p-72]);
  (6%nat, 0x3a5f268af491bp-51, [0xf859430c044e5p-73; 0x1ccb84c0cac831p-58; 0x95aa484ce18e7p-54; 0x1382d33f0bfef5p-54; 0xa335d87df8569p-53; 0x1560f4629e9975p-55; 0x11f4c5f2c2efe5p-57]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (13%nat, 0x1fffffffffffffp-53, [0xa67818202dff1p-351; 0xf9b4243044fe5p-299; 0x138212d3c563d9p-248; 0x1a02c3c5072fc5p-198; 0x9c10969e2b1e7p-147; 0xf9b4243044fd3p-99; 0x1fffffffffffc1p-53])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x1p-1; 0x10000000000001p-53; 0x10000000000001p-53; 0x8000000000001p-52; 0x10000000000003p-53; 0x4000000000001p-51; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (12%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (9%nat, 0x10000000000001p-53, [0x7fffffffffffdp-208; 0x9aaaaaaaaaaa7p-153; 0x50aaaaaaaaaa9p-100; 0xffffffffffffbp-52; 0x15555555555555p-109; 0; 0]);
  (12%nat, 0x6919daf770321p-51, [0x112ff7a9988429p-61; 0xb91885b9c87f5p-57; 0x19f4801b0b85b9p-56; 0xf875d1ea314afp-54; 0x14e77af5596c5p-50; 0x3c086ff208f0bp-52; 0x11f56bb7de7d83p-56]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (12%nat, 0x7ffffffffffffp-51, [0x1000000000000bp-352; 0x1800000000000bp-300; 0x7800000000001p-247; 0x4ffffffffffffp-196; 0x1dfffffffffffp-145; 0x2fffffffffffdp-97; 0x1fffffffffffdp-49])]);
(6%nat, [-4; -0xfp-2; -0xfp-2; -0xdp-2; -0xbp-2; -0x9p-2; -2; -0x7p-2; 0x1p-1; 1; 0x3p-1; 2; 0x5p-1; 0xfp-2],
 [(6%nat, -2, [0x15555555555555p-64; 0x13763b6a8ef599p-54; 0x10912a13ffb5b7p-53; 0x159bc7f084821fp-55; 0x127fb39e229c59p-59; 0x1cc17479d8ba4bp-69; 0]);
  (6%nat, -0x7p-2, [0; 0x14ba3b7c4a85f5p-55; 0x7c64356caeae7p-52; 0x9daa56f331525p-53; 0xb1b155f325b31p-56; 0x1b780a8de4a5b5p-63; 0x8ab355e008ab3p-70]);
  (6%nat, -0x3dp-5, [0x5161555555555p-66; 0x1f013f67360571p-55; 0x4263fc57d1953p-51; 0x714ceb6759183p-53; 0x90f78c2cf7843p-57; 0xc219daf445dafp-65; 0x315f15f15f15fp-77]);
  (6%nat, -0x1cd0c0c51fb1adp-52, [0x1916aa7c4e7ea3p-78; 0x2f6af3efa4011p-52; 0x100358a1aee9e5p-53; 0x47d64fcdafb25p-52; 0x110cd31458606fp-57; 0x7611c8f2cc677p-62; 0x11a8e2e04add59p-73]);
  (6%nat, -0x9p-2, [0x15555555555555p-64; 0x13763b6a8ef599p-54; 0x10912a13ffb5b7p-53; 0x159bc7f084821fp-55; 0x127fb39e229c59p-59; 0x1cc17479d8ba4bp-69; 0]);
  (6%nat, -0x1c000000000001p-52, [0x15555555555555p-364; 0x14ba3b7c4a85f5p-55; 0x3e321ab657573p-51; 0x4ed52b7998a91p-52; 0x2c6c557cc96cbp-54; 0x1b780a8de4a59fp-63; 0x8ab355e008aa7p-70])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x23p-537; 0x1p-531; 0x1p-531; 0x1p-531; 0x1p-531; 0x1p-531; 0x1p-531; 0x1p-531],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (7%nat, 0x1p-531, [0; 0; 0; 0; 0; 0; 1]);
  (7%nat, 0x23p-537, [0x138f9adp-30; 0x760a4dfp-30; 0x8e765e1p-29; 0xabeff5fp-29; 0xcf82b61p-30; 0x3216b93p-30; 0]);
  (6%nat, 0x23p-538, [0x1p-6; 0x4a489e32dp-36; 0x620492edfp-36; 0x1d231da61p-35; 0x922b745fp-35; 0x2f50e4e1p-36; 0x3216b93p-36]);
  (7%nat, 0x1295ecd177039bp-584, [0x1886b745f316b1p-59; 0xae495c7707421p-55; 0x1efdedafcfc485p-55; 0x58450271021p-44; 0x1f769124348961p-55; 0x11f7fa7ab70d27p-56; 0x17a4f7dfa34c7p-71]);
  (6%nat, -0x1p-531, [1; 0; 0; 0; 0; 0; 0]);
  (7%nat, 0x3ffffffffffffp-581, [0x8d3dcb08d3dcbp-350; 0x34f72c234f72bp-296; 0x8469ee58469e9p-246; 0xb08d3dcb08d33p-196; 0x108d3dcb08d3c5p-147; 0x1a7b9611a7b92bp-99; 0x7ffffffffffe5p-51])]);
(6%nat, [0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0xee6b28023p-6; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0],
 [(6%nat, 0x1dcd65p9, [1; 0; 0; 0; 0; 0; 0]);
  (7%nat, 0x3b9aca01p0, [0; 0; 0; 0; 0; 0; 1]);
  (7%nat, 0xee6b28023p-6, [0x138f9adp-30; 0x760a4dfp-30; 0x8e765e1p-29; 0xabeff5fp-29; 0xcf82b61p-30; 0x3216b93p-30; 0]);
  (7%nat, 0x1dcd650063p-7, [0x138f9adp-36; 0x1790de5fp-36; 0x5ca30ae1p-35; 0x1769563dfp-35; 0x63277d561p-36; 0x5ce4d7513p-36; 0x1p-6]);
  (7%nat, 0xee6b2802d037dp-22, [0x62971ea596d59p-60; 0x140dd902e39d83p-58; 0x1a6b73a3ad2cddp-56; 0x8d83bea67a1b5p-53; 0xc23b6e7567bc9p-53; 0x1befe9d6095c7p-51; 0x1bc530bc2c091bp-62]);
  (6%nat, 0x3b9ac9ffp0, [1; 0; 0; 0; 0; 0; 0])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x1p-195; 0x187b97ae0b6fedp-54; 0xee46e3ec97e1p-48; 0x3fffffffffffp-46; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (10%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (8%nat, 0x187b97ae0b6fedp-54, [0x1225de58727773p-56; 0x45bca3d019755p-52; 0x169eee5652570fp-54; 0x1cae5435f7782dp-55; 0x12044994690793p-56; 0x120693ee95f915p-59; 0]);
  (9%nat, 0x3ee46e3ec97d5p-50, [0x159b36016fdabdp-83; 0xdc855bf31f45p-70; 0x1cd9a4fd5c1101p-68; 0x7d638eef852c5p-60; 0x1225a4eb989677p-56; 0x17f964cecbed6fp-53; 0x5b1fffffff993p-53]);
  (8%nat, 0x193cffcfe57065p-53, [0xb421add09e4afp-67; 0xe845f719dbdb1p-61; 0x582310a483ad7p-56; 0x1e256922d59de1p-56; 0x152209e2f3734bp-54; 0x6fffc046342e1p-52; 0x175af2c1f79ccdp-56]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (10%nat, 0x1fffffffffffffp-53, [0xbb25c93139defp-319; 0x8c2d8d729f18bp-263; 0x2bb9cfc42ce87p-207; 0xe8916cff66ef1p-156; 0x1acd87ac6f583dp-105; 0x17893e217f7fe5p-57; 0x3d0ed83bd01p-42])]);
(6%nat, [-1; -1; -1; -1; -1; -1; -1; -0; 0; 0x27p-6; 0x1cac2c78f9619dp-53; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (10%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (10%nat, 0x1cac2c78f9619dp-53, [0x20a1d2d1deaa5p-66; 0xad75b6210f5ffp-62; 0x16447cc96e079p-54; 0x15468aedd4f009p-55; 0x264f87862d0bfp-50; 0x1b3be672397175p-55; 0]);
  (10%nat, 0xef5cde5cdee81p-52, [0x1f1ed3b1adbdbp-70; 0x960d15a138011p-65; 0x8f214309734a5p-59; 0x109a1bbba2df07p-56; 0xf2dfbe3d61393p-53; 0x1d07329bcde9e9p-54; 0x16c7fffffffff3p-61]);
  (8%nat, 0x17432360051dfp-52, [0x1ff387e6cee981p-60; 0x7d03fcf092845p-54; 0x16f6fb54c4d4f3p-54; 0xbf201067a4021p-53; 0x11a7e014b2c2afp-55; 0x100523a15d8c9p-62; 0x2298767d93603p-69]);
  (6%nat, -3, [1; 0; 0; 0; 0; 0; 0]);
  (10%nat, 0x1fffffffffffffp-53, [0x189e963cf43d3bp-368; 0x1276f0adb72debp-311; 0x1714acd924f963p-256; 0xf631de618a63fp-202; 0xb8a566c927cadp-149; 0xe6cec07b71bd3p-99; 0x7fffffffffff1p-51])]);
(4%nat, [0; 0; 0; 0; 0; 0x15p-6; 0x169262c86bfa7p-50; 0xb06ea9b533a53p-52; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 0; 1]);
  (7%nat, 0xb06ea9b533a53p-52, [0x46b1d3e996759p-54; 0x634ea7dc31cb9p-52; 0x670e37a00a3adp-52; 0x11fb55c4af2e1bp-55; 0]);
  (4%nat, 0x93p-9, [0x1p-12; 0x1bf7efe3de2a7fp-59; 0xd912940c8d4c3p-53; 0x1e860ee4e7ab3p-50; 0x15cf7c699ee7d7p-56]);
  (7%nat, 0x1944371c2db115p-53, [0x76cfead5708a9p-57; 0x15d452d6bd18ddp-55; 0xda06f98e2f3f9p-53; 0x1835090c358019p-54; 0x1649d01f654dcdp-59]);
  (4%nat, -1, [1; 0; 0; 0; 0]);
  (7%nat, 0x3ffffffffffffp-50, [0x1d97476735335fp-250; 0x1d974767353351p-198; 0xee93afb01ced3p-147; 0xcde9a2dcb0381p-98; 0x1fffffffffff99p-53])]);
(4%nat, [0; 0; 0; 0; 0; 0x2ddff995f399dp-51; 0x2ddff995f399dp-51; 0x3p-3; 0x1071917996bed9p-53; 0x134a49a6e95e35p-53; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (9%nat, 1, [0; 0; 0; 0; 1]);
  (7%nat, 0x3p-3, [0x6e62f38fc014bp-53; 0x1871eda60bf2ebp-53; 0x14cb2fa903d937p-58; 0xc4d1d7f67fbe5p-64; 0]);
  (8%nat, 0x94a0dcdca5b2fp-52, [0x1a7adc646e0b75p-65; 0x198ee51ac86e9bp-54; 0x3b39bc297fd0fp-51; 0x45895418aadf9p-53; 0x3f85e3ab7e749p-59]);
  (4%nat, 0x2bcf7a9d1413fp-53, [0x157e1e82764e51p-54; 0xd7b3d8124dfc9p-53; 0xccd61ff28e6dfp-54; 0x14d44304e9c973p-57; 0x11be0dbce907bp-57]);
  (4%nat, -1, [1; 0; 0; 0; 0]);
  (9%nat, 0x7ffffffffffffp-51, [0x33a9539e74b93p-250; 0x849599f49e265p-199; 0x1f1310155510f1p-150; 0xa122a4e47e7efp-99; 0x1fffffffffffd7p-53])]);
(4%nat, [0; 0; 0; 0; 0; 0x1p-3; 0x1acbc802074771p-55; 0x1acbc802074771p-55; 0x1acbc802074771p-55; 0x1p-2; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (9%nat, 1, [0; 0; 0; 0; 1]);
  (5%nat, 0x1p-3, [0x10be14233d76e9p-56; 0x4a70428dcfp-40; 0xdca3cdf7cab39p-53; 0x367fc2530e2f5p-52; 0]);
  (9%nat, 0x11p-5, [0x10ababc8dae27p-51; 0xb38ea35c4bdfp-49; 0x5979d583b4ccfp-52; 0x2657813c6f7ebp-52; 0x51p-12]);
  (4%nat, 0x34d9c96d8c0bdp-53, [0xf17026c011e0dp-62; 0x14af6d8ce69781p-55; 0xcbdcc9b148253p-53; 0x15c796e9f24a61p-54; 0x1958085c159063p-56]);
  (4%nat, -1, [1; 0; 0; 0; 0]);
  (9%nat, 0xffffffffffffdp-52, [0x6d409bdfeb951p-251; 0xe6597816ca361p-200; 0xb62091de42db5p-149; 0x3fffffffffffdp-98; 0x1fffffffffffe1p-53])]);
(4%nat, [0; 0; 0; 0; 0; 0x1p-960; 0x10000000000001p-1012; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (6%nat, 1, [0; 0; 0; 0; 1]);
  (5%nat, 0x1p-960, [0xffffffffffffdp-208; 1; 0x1fffffffffffffp-1012; 0; 0]);
  (4%nat, 0x7p-963, [0x1p-12; 0x1c000000000013p-60; 0x1fc5ffffffffffp-53; 0xc0effffffffffp-1011; 0]);
  (6%nat, 0x1b873485a5178dp-53, [0xc7f32086a4381p-63; 0x99dba5457d5bbp-58; 0xb19635da26565p-55; 0x16c66721539199p-54; 0x118665f8c8c49bp-53]);
  (4%nat, -1, [1; 0; 0; 0; 0]);
  (6%nat, 0x3ffffffffffffp-50, [0x1p-200; 0x3ffffffffffffp-198; 0x5fffffffffffdp-148; 0x3fffffffffffdp-98; 0xffffffffffffp-48])]);
(4%nat, [-4; -0x5p-1; -2; -0x7p-2; -0x3p-2; 0x1p-1; 1; 1; 2; 2; 0x9p-2; 0xbp-2; 0xfp-2],
 [(4%nat, -0x3p-2, [0x7684bda12f685p-54; 0xfa65b5df3eec3p-53; 0xac40e1acc8495p-53; 0x785c268d84595p-55; 0]);
  (7%nat, 2, [0; 0; 0x147ae147ae147bp-57; 0x80bb3ee721a55p-52; 0xea0ea0ea0ea0fp-53]);
  (7%nat, 1, [0x1f07c1f07c1f07p-55; 0xa57eb50295fadp-52; 0x71c71c71c71c7p-54; 0; 0]);
  (4%nat, -0x9p-5, [0x90ad097b425edp-57; 0xffae720628247p-54; 0x1e317ed93dac09p-54; 0x419c7151351dp-48; 0x12c8e7c7016cc3p-60]);
  (4%nat, 0x4474fc9ee0bf7p-52, [0x122f6dbdd2c88dp-65; 0x13ee952a4391d3p-57; 0x88e15f781d593p-53; 0x12f01432292a6dp-53; 0x1a0e4c66a74dbdp-56]);
  (4%nat, -0x7p-1, [0x7684bda12f685p-54; 0xfa65b5df3eec3p-53; 0xac40e1acc8495p-53; 0x785c268d84595p-55; 0]);
  (7%nat, 0x1ffffffffffff5p-52, [0x1bbaaaaaaaaaabp-249; 0x6eeaaaaaaaaa7p-195; 0x147ae147ae155bp-57; 0x101767dce434c3p-53; 0x75075075074f3p-52])]);
(4%nat, [0; 0; 0; 0; 0; 0xfp-537; 0x4baa6cbb5d005p-582; 0x1p-531; 0x1p-531; 0x1p-531; 0x1p-531; 0x1p-531],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (6%nat, 0x1p-531, [0; 0; 0; 0; 1]);
  (5%nat, 0xfp-537, [0x708ca928178cbp-53; 0x47aedb601df4fp-51; 0x32c8a009601a9p-52; 0x59354a2583531p-56; 0]);
  (5%nat, 0xa5aa6cbb5d005p-584, [0x11ce40c2d7b9c3p-56; 0xff565ecf58501p-53; 0xb534cae766fa5p-53; 0x9e921bd4d3d93p-55; 0x19e6e72e25e5fdp-64]);
  (5%nat, 0x356d3d71f2781p-582, [0x654a0bc42bbfdp-57; 0x159e93c9f5a793p-54; 0xe844971ac9703p-53; 0x306dd2bd15033p-52; 0x1cb422f8e48763p-60]);
  (4%nat, -0x1p-531, [1; 0; 0; 0; 0]);
  (6%nat, 0xffffffffffffdp-583, [0x8160efd1c9f07p-251; 0xac813fc26295bp-199; 0x159027f84c52bp-145; 0x75662ef283175p-98; 0xfffffffffffe3p-52])]);
(4%nat, [0x1p40; 0x1p40; 0x1p40; 0x1p40; 0x1p40; 0x40000000000fp-6; 0x10000000000975p-12; 0x10000000001p0; 0x10000000001p0; 0x10000000001p0; 0x10000000001p0; 0x10000000001p0],
 [(4%nat, 0x1p40, [1; 0; 0; 0; 0]);
  (6%nat, 0x10000000001p0, [0; 0; 0; 0; 1]);
  (5%nat, 0x40000000000fp-6, [0x3842c6b016069p-52; 0x8f5fc3a108099p-52; 0xcb27cd373f6b9p-54; 0x59382611214fp-52; 0]);
  (4%nat, 0x80000000000fp-7, [0x1p-4; 0x1298364a1738cdp-53; 0xa38b924001199p-53; 0x91f4c69348b7bp-56; 0x59382611214fp-56]);
  (6%nat, 0x10000000000b1fp-12, [0x1c470170ad78c7p-58; 0x1a097e7e2c2be3p-55; 0xfc18d66d8f4ebp-53; 0x22de52cbe4991p-51; 0x8918ec75b8481p-59]);
  (4%nat, 0xffffffffffp0, [1; 0; 0; 0; 0])]);
(4%nat, [0; 0; 0; 0; 0; 0x1p-111; 0x9p-6; 0x11b033713f49f9p-53; 0xffffffp-24; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (8%nat, 1, [0; 0; 0; 0; 1]);
  (8%nat, 0xffffffp-24, [0x14d081c5adfc0dp-123; 0xf9c613d5db533p-97; 0xd6a6376cdb40dp-73; 0x1fffff2959c799p-53; 0]);
  (8%nat, 0x3fffffdp-26, [0x1a57e43e3032ffp-125; 0xe44f0e887ffd5p-98; 0x8f61079fa30bfp-73; 0x1fdfff709ef7edp-53; 0x1p-8]);
  (5%nat, 0x41f37094b475p-50, [0x1617e324dd51efp-56; 0xb38dd4ed44d81p-52; 0x19b29d9bf99fd1p-55; 0x173458299ccdc5p-59; 0x1d03616df940d3p-65]);
  (4%nat, -1, [1; 0; 0; 0; 0])]);
(4%nat, [-1; -1; -1; -1; -1; -0; 0; 0x9p-6; 0xdp-5; 1; 1; 1; 1; 1],
 [(4%nat, -1, [1; 0; 0; 0; 0]);
  (8%nat, 1, [0; 0; 0; 0; 1]);
  (8%nat, 0xdp-5, [0x1f2d61bed61bedp-55; 0xeb932b13613cdp-53; 0x8898ca67e21ffp-53; 0x78f41c4b219c1p-56; 0]);
  (4%nat, -0x3p-2, [0x51p-8; 0x1bp-6; 0x1bbf50c0ecbc81p-55; 0x15c389794cfa07p-57; 0x13f33830013f33p-61]);
  (4%nat, -0x93b496bb5402bp-52, [0x38bda8c2cbb3bp-53; 0xa667a81128191p-53; 0x18491a16c21e93p-54; 0xa8b2207dab563p-54; 0xa38ce3725938fp-57]);
  (4%nat, -3, [1; 0; 0; 0; 0]);
  (8%nat, 0x1ffffffffffffp-49, [0xfadb02346cc4fp-247; 0x7d6d811a36623p-195; 0x2f091069d464bp-144; 0xd79435e50d777p-98; 0x7ffffffffffe5p-51])]);
(3%nat, [0; 0; 0; 0; 0xfp-6; 0x1bp-6; 0x1bp-6; 0x159e105a8cca45p-53; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 1]);
  (6%nat, 0x1bp-6, [0x24ccb247f566bp-50; 0x1b334db80a995p-50; 0; 0]);
  (3%nat, 0xfp-8, [0x1bp-6; 0x7cca4587e6b75p-52; 0xafcd6e9e06523p-55; 0x13c0ca4587e6b7p-60]);
  (7%nat, 0xbcc76725afa6fp-52, [0x155ec5163d4c47p-55; 0x78aa8f69dd0fdp-52; 0xb5a2d761eaa8bp-53; 0x719eae2cc0d31p-58]);
  (3%nat, -1, [1; 0; 0; 0]);
  (7%nat, 0x3ffffffffffffp-50, [0x49c5a582f031p-193; 0xffe5961e31297p-148; 0x93f0bac9746b9p-98; 0x1fffffffffffb7p-53])]);
(3%nat, [0; 0; 0; 0; 0xbp-5; 0x13p-5; 0xf48a7282c1525p-52; 0xf48a7282c1525p-52; 0xf48a7282c1525p-52; 0xf48a7282c1525p-52; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (9%nat, 1, [0; 0; 0; 1]);
  (5%nat, 0x13p-5, [0x1ca2914f388c69p-55; 0x9bf08ff66d733p-52; 0x156526b590b9fbp-55; 0]);
  (4%nat, 0x7p-4, [0x1629215463479fp-57; 0x115f4eb6103d05p-53; 0x19ebd3a4098c19p-54; 0x483562a4c873bp-57]);
  (5%nat, 0x5ec779681d96bp-51, [0x1805ea8ab81017p-57; 0x1870248dbe7a5p-50; 0x1023e618a6e4b3p-53; 0x111d47be72e921p-56]);
  (3%nat, -1, [1; 0; 0; 0]);
  (9%nat, 0x1ffffffffffffbp-53, [0x1544203a676c55p-191; 0x1246e5432d47d5p-143; 0x14f1a2aa66ba7dp-97; 0x1ffffffffffeb1p-53])]);
(3%nat, [0; 0; 0; 0; 0x1p-3; 0x879d1af9c1363p-54; 0x879d1af9c1363p-54; 0x7p-3; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 1]);
  (7%nat, 0x7p-3, [0x1541f856aff277p-58; 0xfc903e1bcdbd1p-54; 0x17716e4c6c1283p-53; 0]);
  (4%nat, 0x4261186e0c60fp-53, [0x15c957afe476bdp-65; 0x14e1a6fa586309p-58; 0xfa1e1338e9667p-52; 0x13d3cb9511d28bp-61]);
  (7%nat, 0xefefb5b8c07bfp-52, [0x15832880da9a93p-61; 0x15dfaeeb51b991p-56; 0xc9d5921a7e631p-52; 0x1f9ea5b6290e8dp-56]);
  (3%nat, -1, [1; 0; 0; 0]);
  (7%nat, 0x1ffffffffffff9p-53, [0x1c7b63bc25bdddp-200; 0x152e12dbb0a671p-148; 0xa7fffffffffebp-97; 0x3ffffffffffebp-50])]);
(3%nat, [0; 0; 0; 0; 0x1p-960; 0x10000000000001p-1012; 0x8000000000001p-1011; 0x8000000000001p-1011; 0x10000000000003p-1012; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (8%nat, 1, [0; 0; 0; 1]);
  (7%nat, 0x8000000000001p-1011, [0x1p-1; 0x1p-1; 0; 0]);
  (3%nat, 0x7p-963, [0x1p-9; 0x15000000000009p-57; 0x12600000000007p-54; 0x55bffffffffffp-51]);
  (8%nat, 0x6be68c6846fp-50, [0xfaf9b39a018e9p-52; 0x4fdcf01e4a283p-56; 0x43c4ca75e0623p-63; 0x132b2c4b85e155p-74]);
  (3%nat, -1, [1; 0; 0; 0]);
  (8%nat, 0x3ffffffffffffp-50, [0x1p-150; 0xbfffffffffffdp-150; 0x5fffffffffffdp-99; 0x3fffffffffffdp-50])]);
(3%nat, [-0x7p-1; -0x7p-1; -0xdp-2; -0x9p-2; -0x3p-1; -0x1p-2; 0xbp-2; 0xbp-2; 0x7p-1],
 [(3%nat, -0x9p-2, [0x5249249249249p-53; 0x14c30c30c30c3p-49; 0x30c30c30c30c3p-52; 0]);
  (4%nat, -0x1p-2, [0; 0x1b1b1b1b1b1b1bp-54; 0x1f5b97d4104c89p-54; 0x16253443526171p-56]);
  (4%nat, -0x3p-1, [0x10aaaaaaaaaaabp-54; 0xaeeeeeeeeeeefp-52; 0x7333333333333p-55; 0]);
  (3%nat, -0x39p-5, [0x8adb6db6db6dbp-58; 0x74e8f3cf3cf3dp-52; 0x10acf3cf3cf3cfp-53; 0xe1p-14]);
  (3%nat, -0x184008fac9aa99p-52, [0x186bcab8ade553p-72; 0x8a659f85bbe1dp-53; 0x2b521ca2d90ffp-50; 0xd84a545f316bp-52]);
  (3%nat, -0x11p-2, [0x5249249249249p-53; 0x14c30c30c30c3p-49; 0x30c30c30c30c3p-52; 0]);
  (4%nat, -0x800000000001p-49, [0x11111111111111p-202; 0xd8d8d8d8d8d95p-53; 0xfadcbea082641p-53; 0x16253443526157p-56])]);
(3%nat, [0; 0; 0; 0; 0x1p-536; 0x1p-531; 0x1p-531; 0x1p-531; 0x1p-531],
 [(3%nat, 0, [1; 0; 0; 0]);
  (4%nat, 0x1p-531, [0; 0; 0; 1]);
  (4%nat, 0x1p-536, [0x3c1p-10; 0x1fp-9; 0x1p-10; 0]);
  (4%nat, 0x65p-539, [0x1d53dp-19; 0x1c313p-18; 0x2389dp-19; 0x1b000000000001p-57]);
  (4%nat, 0x6331de084dcb3p-582, [0x605fd28f675a9p-57; 0x7c10db3292a93p-54; 0x1a89308d0705edp-54; 0x1cf5021ab100cbp-54]);
  (3%nat, -0x1p-531, [1; 0; 0; 0]);
  (4%nat, 0x3ffffffffffffp-581, [0x4210842108421p-200; 0x6318c6318c63p-145; 0xc6318c6318c5dp-100; 0xffffffffffff3p-52])]);
(3%nat, [-0x1dcd65p9; -0x1dcd65p9; -0x1dcd65p9; -0x1dcd65p9; -0x773593fffp-5; -0x3b9ac9ffp0; -0x3b9ac9ffp0; -0x3b9ac9ffp0; -0x3b9ac9ffp0],
 [(3%nat, -0x1dcd65p9, [1; 0; 0; 0]);
  (4%nat, -0x3b9ac9ffp0, [0; 0; 0; 1]);
  (4%nat, -0x773593fffp-5, [0x3c1p-10; 0x1fp-9; 0x1p-10; 0]);
  (3%nat, -0x1dcd64ffffp-7, [0x1bp-6; 0x92a1p-16; 0xafp-15; 0x1p-16]);
  (4%nat, -0xee6b27fde07c3p-22, [0x1b4ce3917ff05bp-56; 0x16f0e75f0cde7p-50; 0x19759d82f981bdp-54; 0x231908e6668efp-52]);
  (3%nat, -0x3b9aca01p0, [1; 0; 0; 0])]);
(3%nat, [0; 0; 0; 0; 0x1p-70; 0xbb89931fe0ad5p-53; 0x1f2c71e93541f7p-53; 0x7ffffp-19; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 1]);
  (5%nat, 0xbb89931fe0ad5p-53, [0x18eba9616ef78dp-54; 0x1e43ebb9e10907p-54; 0x11a0d5c95ffedbp-55; 0]);
  (6%nat, 0x1fb0a83773f8bdp-53, [0x3a2f1d2597c45p-64; 0x7a119f209f307p-57; 0x17b5c5a3526fc7p-53; 0x3e7da2fa952edp-52]);
  (4%nat, 0x147b90dc8c0d3p-50, [0x83de3668d7f2dp-60; 0xf6c248708b0bbp-53; 0x6c964dc5e0b6bp-52; 0xbc257e5b875c5p-55]);
  (3%nat, -1, [1; 0; 0; 0])]);
(3%nat, [-1; -1; -1; -1; -0; 0; 0x1fp-6; 0x166d12c0ce7fa5p-53; 1; 1; 1; 1],
 [(3%nat, -1, [1; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 1]);
  (6%nat, 0x1fp-6, [0x61abdcd027df9p-54; 0x123c1b46a9efcdp-53; 0x156d0ba5a9a26dp-54; 0]);
  (6%nat, 0x90c738426b7efp-52, [0x17d87568d1bc13p-58; 0x1d0a51b6c66af5p-54; 0x106ff52e1275c1p-53; 0x130792d0f1b9p-51]);
  (7%nat, 0x5a659f5077e69p-51, [0xa84ada5555acbp-54; 0xa55a63228b2d9p-52; 0x309282fec38c1p-52; 0x63495bdb37ba1p-68]);
  (3%nat, -3, [1; 0; 0; 0]);
  (7%nat, 0x7ffffffffffffp-51, [0x67b749bf040e1p-201; 0x9b92ee9e8614fp-149; 0xa06f86137a455p-99; 0x1fffffffffffd7p-53])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x3p-6; 0x9p-5; 0x1b7472a5968e65p-54; 0x21p-6; 0xc73e534af1fc7p-52; 0x35p-6; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (11%nat, 1, [0; 0; 0; 0; 0; 1]);
  (11%nat, 0x35p-6, [0xa233ab8d85e69p-57; 0xc5896e0e6f609p-54; 0xf09f619c40745p-53; 0x5095181aa2051p-52; 0xa73e3735b95ffp-60; 0]);
  (7%nat, 0x645d57f0c3ab3p-52, [0x102b6ab10d5989p-68; 0xb9101150884c1p-58; 0x985894de0ec71p-53; 0x1fa4ef6ece3269p-54; 0x18dc76f93eaf5bp-55; 0x50e373aaa10d7p-59]);
  (11%nat, 0x1e7457fb246459p-53, [0x12306dd73132f3p-67; 0x11f941b657c5e3p-61; 0xac3f6a6ab128dp-56; 0x143a908abfe163p-54; 0x1ca3d7d94a84bfp-54; 0xc4c15eb6f6c25p-54]);
  (5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (11%nat, 0xffffffffffffdp-52, [0x1f5385f261e081p-298; 0x961ae1d414fe1p-244; 0xe4912282c829bp-194; 0x939dbb9f2145p-140; 0x5745d1745d15fp-96; 0x1fffffffffff5p-49])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x7p-6; 0x526e8a5cb580fp-52; 0x29p-6; 0x29p-6; 0x29p-6; 0x29p-6; 0x29p-6; 0x29p-6; 0xe81cbb7ed294bp-52; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (14%nat, 1, [0; 0; 0; 0; 0; 1]);
  (14%nat, 0xe81cbb7ed294bp-52, [0x129df65c0484abp-60; 0x6a2acc2c9fdb1p-55; 0xe30a142b79427p-54; 0x1af940849a646fp-54; 0x133a4ffdd8f67fp-54; 0]);
  (6%nat, 0x1134b9f162082dp-54, [0xc2af41cf2d499p-64; 0x1461bd24729e2fp-55; 0xc43f0d05276b5p-53; 0x1573c2c91b99a9p-54; 0x3b657203028ffp-53; 0xc7880d3d36455p-59]);
  (7%nat, 0xb41ef7259ecf1p-53, [0x171fba5590ce57p-57; 0x70b2d4a0b6835p-53; 0x19251db9143619p-54; 0x95b5e28a7340dp-53; 0x6536c273e56cdp-55; 0x1e03354c30823p-66]);
  (5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (14%nat, 0x1ffffffffffff9p-53, [0x293167a844275p-291; 0xa92f7c05610e9p-242; 0x8af94a7222023p-192; 0xe4506804a5949p-144; 0x5dc5986f9f6e7p-95; 0x1ffffffffffe8bp-53])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x1p-1; 0x13ab9754b6f78dp-53; 0x14ff42275a8fe1p-53; 0x1507d8179aa9bfp-53; 0x3p-2; 0x1fe5c11208e6e9p-53; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (11%nat, 1, [0; 0; 0; 0; 0; 1]);
  (7%nat, 0x13ab9754b6f78dp-53, [0x4640803ccdf31p-64; 0x3f9946c35482dp-58; 0x15b48ca798d567p-55; 0x18a18b1d54adbbp-53; 0x1d0f89462f90cfp-57; 0]);
  (8%nat, 0x150054e562931dp-53, [0x1d7716e25f35e3p-85; 0x42fe635b5f045p-55; 0xb6692a8364565p-52; 0x1013aa3fc32e33p-54; 0x1d0c0226ea9c43p-61; 0xaf840ec07220bp-98]);
  (10%nat, 0x1adf4c1c11eda9p-53, [0x120bda564510ffp-58; 0x277a43fa49949p-52; 0xb57051d901123p-53; 0xa924ab82d2dcbp-53; 0x8cb0eafdc849dp-54; 0x630300b247547p-58]);
  (5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (11%nat, 0x1ffffffffffffdp-53, [0x32f7b733b38b7p-292; 0x105d720dd16b3fp-242; 0x780ab0f46a46bp-190; 0x36ddaa7b7651fp-139; 0x924f1bf3e61f1p-92; 0x1fffffffffedb5p-53])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x1p-1; 0x10000000000001p-53; 0x10000000000001p-53; 0x8000000000001p-52; 0x10000000000003p-53; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (10%nat, 1, [0; 0; 0; 0; 0; 1]);
  (6%nat, 0x1p-1, [0x3ffffffffffffp-258; 0x1ffffffffffff9p-207; 0x15fffffffffff9p-153; 0xdfffffffffffbp-101; 0xffffffffffff9p-52; 0]);
  (8%nat, 0x10000000000001p-53, [0x3ffffffffffffp-155; 0x8aaaaaaaaaaa9p-102; 0x7ffffffffffffp-51; 0x15555555555555p-107; 0; 0]);
  (5%nat, 0x649713f69f41bp-53, [0x546de268ae27dp-54; 0x1113cb6ac83737p-54; 0xb0dacf5007f95p-53; 0x393c394757791p-52; 0x1285e0f8cbaa65p-56; 0x132ebe9463c8c3p-59]);
  (5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (10%nat, 0x7ffffffffffffp-51, [0x10000000000007p-302; 0x5000000000001p-248; 0x9ffffffffffffp-198; 0x27fffffffffffp-146; 0x13fffffffffffp-96; 0x3fffffffffffbp-50])]);
(5%nat, [-4; -0xbp-2; -0x5p-1; -2; -0x3p-1; -0x3p-2; -0x3p-2; -0x1p-1; 0x5p-2; 0x5p-2; 0x9p-2; 0x5p-1; 0x5p-1; 0xbp-2; 3; 3; 0xfp-2],
 [(6%nat, -0x3p-2, [0x15555555555555p-60; 0x1002af70c880e5p-53; 0x3826a008ae07bp-51; 0xe47ef130a9419p-56; 0; 0]);
  (10%nat, 0x5p-1, [0; 0; 0x71c71c71c71c7p-57; 0x9145145145145p-53; 0x52cb2cb2cb2cbp-51; 0x71c71c71c71c7p-55]);
  (7%nat, -0x1p-1, [0x21949660abdc3p-51; 0x861a871457e21p-52; 0x1ac1b44e0bc1p-47; 0x13253253253253p-60; 0xd20d20d20d20dp-65; 0]);
  (6%nat, -0x13p-5, [0x51p-21; 0xae5348479bbf9p-53; 0x84f0fb263ed1fp-52; 0x8eb25f4994559p-54; 0x6b4143d43d43dp-61; 0x14083483483483p-69]);
  (9%nat, 0x82f9bce5c74d5p-50, [0x1d93b46551b88bp-69; 0x4f84f2ad35099p-58; 0x149ca45339dc05p-56; 0x80b88caa66bf9p-52; 0x155a73729cb53fp-54; 0x140200cf9490bbp-56]);
  (6%nat, -4, [0x15555555555555p-60; 0x1002af70c880e5p-53; 0x3826a008ae07bp-51; 0xe47ef130a9419p-56; 0; 0]);
  (10%nat, 0x9fffffffffffdp-50, [0x1fe6cb398064d3p-297; 0x15999999999985p-244; 0xe38e38e38e463p-58; 0x48a28a28a28b9p-52; 0x52cb2cb2cb2c5p-51; 0xe38e38e38e2b9p-56])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x8e3d6f4982f5fp479; 0x1p531; 0x1p531; 0x1p531; 0x1p531; 0x1p531; 0x1p531],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (6%nat, 0x1p531, [0; 0; 0; 0; 0; 1]);
  (6%nat, 0x8e3d6f4982f5fp479, [0x13f70888e0c0ddp-57; 0x63da58cbb806fp-53; 0x1768dbbe13960fp-54; 0x9c1b9d4c03d75p-53; 0xc3308dbb1ac1bp-55; 0]);
  (5%nat, 0x8e3d6f4982f5fp476, [0x1069bfffffffffp-53; 0x1a9e89d1426db1p-54; 0x86f7a0aa9f665p-55; 0x530578da48d65p-58; 0x64efb0ae527c9p-63; 0xc3308dbb1ac1bp-70]);
  (5%nat, 0x167da9ca1cdp482, [0x1f379902afd72fp-53; 0x18e9957725c557p-58; 0x4662ab22c284dp-63; 0x18d48b458d4bb5p-74; 0x460b90fdc16cbp-81; 0x9e0a805a9d3b1p-93]);
  (5%nat, -0x1p531, [1; 0; 0; 0; 0; 0]);
  (6%nat, 0x3ffffffffffffp481, [0x9005c113e48c3p-300; 0x1680e62b1bb5dfp-249; 0x1680e62b1bb5d7p-198; 0xb4073158ddae7p-147; 0xb4073158ddae1p-98; 0x1fffffffffffa7p-53])]);
(5%nat, [0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x3b9aca008e3d7p-20; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0],
 [(5%nat, 0x1dcd65p9, [1; 0; 0; 0; 0; 0]);
  (6%nat, 0x3b9aca01p0, [0; 0; 0; 0; 0; 1]);
  (6%nat, 0x3b9aca008e3d7p-20, [0x9fb8404629fc1p-56; 0xc7b4aed693a53p-54; 0xbb46dd784f0b3p-53; 0x9c1b9eaa6f73dp-53; 0xc33091a4c9bb9p-55; 0]);
  (5%nat, 0x1dcd65002c7333p-23, [0xf3p-15; 0xfff49b878b021p-54; 0x65924a79aa9a9p-52; 0x211a85de6d57p-47; 0x50075bbc7f493p-54; 0x94eafe1e0928fp-58]);
  (5%nat, 0x1dcd65001c48c7p-23, [0xa254b47afa4adp-55; 0xef437fbb10371p-53; 0x15362d082ff9b7p-54; 0xd739221829435p-55; 0x415ad3a0f8409p-56; 0x1f11faa203ea9bp-63]);
  (5%nat, 0x3b9ac9ffp0, [1; 0; 0; 0; 0; 0])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x1p-99; 0x303b61ee3a3d9p-50; 0x7p-3; 0x3fffffffffffp-46; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (9%nat, 1, [0; 0; 0; 0; 0; 1]);
  (8%nat, 0x7p-3, [0x81e20c8676d4fp-61; 0xca76ea96e6a6fp-57; 0xdce95efea7565p-54; 0x1663983d357bbfp-53; 0xf143dfbafdbc5p-56; 0]);
  (5%nat, 0x1p-102, [0x41a7p-15; 0x1f2c7fffffffffp-54; 0x176c5b063ab6fp-150; 0xe3d9ed2b87581p-255; 0xec922fc0264efp-358; 0x610e06763719dp-461]);
  (6%nat, 0x1628cbaa563dbp-49, [0x1d7de952477e8dp-71; 0x171d784045bc59p-61; 0x110da06a91d70bp-56; 0x442f4db825bf1p-52; 0xd8712bb07a72fp-53; 0x1ee8aaa39b2effp-55]);
  (5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (9%nat, 0x3ffffffffffffp-50, [0x103c4190cee0f3p-251; 0xa0530775faecfp-198; 0x9d57f76c64f11p-147; 0x12c9dfffffffc5p-100; 0x11a6c3ffffffb5p-54; 0xb964fp-20])]);
(5%nat, [-1; -1; -1; -1; -1; -1; -0; 0; 0x11p-5; 0x37p-6; 1; 1; 1; 1; 1; 1],
 [(5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (9%nat, 1, [0; 0; 0; 0; 0; 1]);
  (9%nat, 0x37p-6, [0xdab3333333333p-63; 0xa2bbeb851eb85p-57; 0xa8db1ba5e353fp-54; 0x9320d1c432ca5p-52; 0x7aee631f8a09p-49; 0]);
  (7%nat, 0x77p-8, [0xab0c55e5fad59p-71; 0xbad0cf32b0f29p-58; 0x15d97505148bfdp-55; 0x8be3089b0b437p-52; 0x1ca9955215d585p-55; 0x1857143094f209p-57]);
  (5%nat, -0x27644c5797b0bp-51, [0x169d115a300de3p-61; 0x7f2af08211d19p-56; 0x130ff18eb2526fp-54; 0xe2edf0d1fcb29p-53; 0x193e07bbfa8f7p-51; 0x1c966945428263p-58]);
  (5%nat, -3, [1; 0; 0; 0; 0; 0]);
  (9%nat, 0x3ffffffffffffp-50, [0x1e573ac901e573p-300; 0x12f684bda12f5dp-246; 0x97b425ed097a7p-194; 0x25ed097b425e7p-142; 0x11c71c71c71c1fp-97; 0x1ffffffffffee3p-53])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x13e1c2edb16e75p-57; 0xe9d97a311cf95p-55; 0x9p-6; 0xe0d02d605aff5p-53; 0x1fe7667386d217p-54; 0x1d6090e72f8fbp-49; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (11%nat, 1, [0; 0; 0; 0; 0; 1]);
  (9%nat, 0xe0d02d605aff5p-53, [0xcf3fd9b47dc35p-63; 0x746fb28f6313p-49; 0x1f30e7fb9aba39p-54; 0xfc1e5fcf995fbp-54; 0x278c1b6b1a97fp-54; 0]);
  (11%nat, 0xfd6090e72f8fbp-52, [0x1b9f7bf0001fa7p-80; 0xb399fd983456bp-70; 0xdfa6d16bd79e9p-63; 0xb126d1409c42fp-57; 0x770ca799aec1p-48; 0x41a7p-15]);
  (10%nat, 0xe73973a737319p-52, [0xde4c4a556a6bp-75; 0x3f651d90899c1p-61; 0xea74fcf0f5d37p-58; 0x4cdc24572fa85p-53; 0x6d07ecbe4834fp-52; 0x68c07a77ca519p-52]);
  (5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (11%nat, 0x1fffffffffffffp-53, [0x71f3d6ad7b13fp-310; 0x1f8b45b97d20bbp-257; 0x6c6ebfad9e207p-201; 0x79a46a6f4d0f7p-149; 0xf403dade72c63p-99; 0x1fffffffffffc3p-53])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x1p-6; 0x1p-6; 0x1p-6; 0x5p-5; 0x1f8a2c24ced027p-53; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (10%nat, 1, [0; 0; 0; 0; 0; 1]);
  (10%nat, 0x1f8a2c24ced027p-53, [0x1c8cbbd51c195p-73; 0x1e10b4800faf6bp-69; 0xbde39a36dafefp-61; 0x10a3dbda38a61dp-56; 0x1ddf881dd441a7p-53; 0]);
  (9%nat, 0x1de7a11b9b1c1dp-54, [0xcd769cafd2de9p-56; 0xe0aa160ac3357p-54; 0x2d459d219bd45p-51; 0x118705eedd6449p-54; 0x312217a0bf86dp-53; 0x1c5b2e34507a51p-60]);
  (9%nat, 0xcc09680255aebp-53, [0x17efdd801f753bp-56; 0x26743d7dcf715p-51; 0x16b849140cd0efp-54; 0x66449a9cef0f3p-53; 0x3288705103abbp-54; 0x10433a2abe3d45p-61]);
  (5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (10%nat, 0x1ffffffffffff9p-53, [0x589dfdc4761d7p-295; 0x7c9e2cdc4617dp-243; 0x8c31f277ced83p-192; 0x9db830c6c8ae7p-142; 0x26058bc234f0fp-91; 0xffffffffffb41p-52])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x3p-2; 0x3p-2; 0x3p-2; 0x3p-2; 0x3p-2; 0x3p-2; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (11%nat, 1, [0; 0; 0; 0; 0; 1]);
  (11%nat, 0x3p-2, [1; 0; 0; 0; 0; 0]);
  (11%nat, 0x1bp-5, [0xc35p-15; 0x249fp-15; 0x15f9p-14; 0xd2fp-14; 0x7e9p-15; 0xf3p-15]);
  (5%nat, 0x1536bd85f81f85p-53, [0x2c38267c6cb65p-65; 0x349b650736e83p-60; 0x642318c6df275p-57; 0xbe9c3ccb79fbp-51; 0xb569a86eab6fdp-53; 0x8a208e42c8f53p-52]);
  (5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (11%nat, 0xfffffffffffffp-52, [0x1p-250; 0x13fffffffffffbp-250; 0x9fffffffffffbp-198; 0x13fffffffffff1p-149; 0x4fffffffffffbp-98; 0x3fffffffffffbp-50])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x1p-1; 0x10000000000001p-53; 0x8000000000001p-52; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (8%nat, 1, [0; 0; 0; 0; 0; 1]);
  (6%nat, 0x1p-1, [0x3ffffffffffffp-258; 0x77ffffffffffdp-203; 0x10000000000003p-54; 0x1p-1; 0xffffffffffffdp-54; 0]);
  (8%nat, 0x18000000000001p-53, [0xffffffffffff9p-59; 0xbfffffffffffdp-55; 0xcbfffffffffffp-53; 0x14000000000003p-54; 0x14000000000003p-55; 0x1p-5]);
  (5%nat, 0x124fa17d4d6e9p-53, [0x16146d74fd1fbdp-53; 0x110282ffe6de55p-54; 0x53dd98ddee6ddp-55; 0xd2c254789c37dp-60; 0x8161be1987f61p-65; 0x1f69514a5cbeb7p-74]);
  (5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (8%nat, 0x7ffffffffffffp-51, [0x10000000000003p-304; 0x13ffffffffffffp-251; 0x9fffffffffffdp-198; 0x4fffffffffffdp-147; 0x9fffffffffff7p-99; 0x3fffffffffffbp-50])]);
(5%nat, [-0xfp-2; -0xbp-2; -0x5p-1; -0x9p-2; -2; -0x5p-2; 0x1p-1; 0x3p-1; 2; 3; 0xfp-2; 0xfp-2],
 [(5%nat, -0x5p-2, [0x8f46c5e0bb23p-50; 0x3f528de30cbc7p-51; 0x9edbb077f2f65p-53; 0x1b49b96ef5f14bp-57; 0x1d9f7390d2a6c5p-62; 0]);
  (5%nat, 0x1p-1, [0; 0x1c5edd33a4aea9p-60; 0x1ef4a141dd5b7p-52; 0xea2691fb9aef1p-53; 0xbb1b965832dc3p-53; 0xca45cc1017407p-56]);
  (5%nat, 0x9p-5, [0x8f46c5e0bb23p-65; 0x130d812f12f12fp-58; 0xc70e4278ee0f9p-54; 0x1f0c7933c88cc1p-54; 0x8d95da30e81f3p-53; 0x19efd62c1a3343p-58]);
  (5%nat, -0x4f525a65a0ed5p-50, [0x115fae7c9c1357p-55; 0xfbbbac55394f7p-53; 0xa15fe22800195p-53; 0xe33c13d5ed307p-56; 0x1fc6a2b2f82bb7p-62; 0x714197abbc395p-92]);
  (5%nat, -3, [0x8f46c5e0bb23p-50; 0x3f528de30cbc7p-51; 0x9edbb077f2f65p-53; 0x1b49b96ef5f14bp-57; 0x1d9f7390d2a6c5p-62; 0]);
  (5%nat, 0x7fffffffffff9p-52, [0x8f46c5e0bb23p-300; 0xe2f6e99d25773p-59; 0xf7a50a0eeadc9p-55; 0x3a89a47ee6bbdp-51; 0x176372cb065b79p-54; 0x1948b98202e7edp-57])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x1p-536; 0x1c5736f9e30125p-586; 0x1c5736f9e30125p-586; 0x1p-531; 0x1p-531; 0x1p-531; 0x1p-531; 0x1p-531; 0x1p-531],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (8%nat, 0x1p-531, [0; 0; 0; 0; 0; 1]);
  (8%nat, 0x1c5736f9e30125p-586, [0xf972fcb7cbbb5p-53; 0x6661ed636bc87p-52; 0xd7a715f07edadp-55; 0x1efb1829e7e8e5p-60; 0; 0]);
  (6%nat, 0xa15cdbe78c049p-586, [0x421c1e13519f9p-53; 0x1577e1154effd9p-54; 0x1f1880432f5903p-54; 0x61ec3eb371189p-55; 0x7267d18f02209p-60; 0x1efb1829e7e8dfp-70]);
  (8%nat, 0xe7e36656f0825p-584, [0xaaed239968e3p-51; 0x12e62c83bf5b4bp-54; 0xc5bdbb1102defp-53; 0xd22c424703b25p-54; 0xe0ee6142ff1e9p-57; 0x9848597b2158fp-60]);
  (5%nat, -0x1p-531, [1; 0; 0; 0; 0; 0]);
  (8%nat, 0x3ffffffffffffp-581, [0xd9f67a05da9edp-301; 0x11074188751463p-249; 0x883a0c43a8a2fp-197; 0x83f83be18b5dbp-147; 0x19b000d849585p-96; 0x1fffffffffffc9p-53])])].

Definition rows_3 : list (nat * list float * list (nat * float * list float)) := [
(5%nat, [0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x773594001p-5; 0x1dcd65001c5737p-23; 0x1dcd65001c5737p-23; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0],
 [(5%nat, 0x1dcd65p9, [1; 0; 0; 0; 0; 0]);
  (8%nat, 0x3b9aca01p0, [0; 0; 0; 0; 0; 1]);
  (8%nat, 0x1dcd65001c5737p-23, [0x3e5cbf227905dp-51; 0xccc3dadc1e87fp-53; 0x6bd38b23aad55p-54; 0x1efb18413fb125p-60; 0; 0]);
  (5%nat, 0x1dcd650001p-7, [0xf3p-10; 0xb254ed1cb0c03p-52; 0x103e12b6cd00ebp-56; 0x2b106577485edp-58; 0xbe450cffaf409p-68; 0x1466076d6204a7p-78]);
  (8%nat, 0xee6b280399b17p-22, [0x8e322147af693p-67; 0x18afd268f96b13p-63; 0xd9f7a78238587p-58; 0xe5e6f3f4ec9efp-55; 0x17b4f3b0a3c747p-54; 0x101a9f02f6bd6dp-53]);
  (5%nat, 0x3b9ac9ffp0, [1; 0; 0; 0; 0; 0])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x1p-171; 0x4da748f2ca15fp-51; 0x1dp-5; 0x1ffffp-17; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (9%nat, 1, [0; 0; 0; 0; 0; 1]);
  (8%nat, 0x1dp-5, [0xcddfd7ce690f9p-64; 0x1ddc5f5d419f15p-60; 0x194f049f18a927p-56; 0x474f7aae5caffp-51; 0x1589d884373d9fp-54; 0]);
  (5%nat, 0x3p-173, [0x1p-10; 0x3ffp-10; 0x2446cc64e5d67p-218; 0xa7476cf6110c3p-391; 0x1391334cb90073p-564; 0xdcfe7f9ec0051p-737]);
  (6%nat, 0x76c8d2b7d1c67p-52, [0x5e441d26438fbp-61; 0xa700055ce1aefp-55; 0x13de3460afce57p-54; 0xbe4772a50ae39p-53; 0x192843d3e9eb63p-55; 0x14079591704ccbp-57]);
  (5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (9%nat, 0x3ffffffffffffp-50, [0x1b1e63d1651847p-281; 0x10f2fe62dd7d39p-228; 0x8797f316d7927p-176; 0x6aaaaaaa7553fp-127; 0x9fffffff5ffcbp-82; 0x1fffffffbp-33])]);
(5%nat, [-1; -1; -1; -1; -1; -1; -0; 0; 0x19p-5; 0xd780914139b11p-52; 1; 1; 1; 1; 1; 1],
 [(5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (9%nat, 1, [0; 0; 0; 0; 0; 1]);
  (7%nat, -0, [0xaccaeeebd1b6bp-55; 0x2b3d6f3bfc48fp-51; 0xd9cf66f171da5p-53; 0x13820818ea251p-51; 0; -0]);
  (5%nat, -0x3p-2, [0xf3p-10; 0x195p-10; 0x9c38c689959f9p-53; 0x1d3406a1a9a97dp-57; 0x4ff61994f999dp-58; 0x13820818ea251p-61]);
  (5%nat, -0xa562aeafa2bc9p-52, [0x1ccf157d8ef321p-56; 0x13bb00213c59c3p-54; 0x36f0de85826efp-51; 0x866f71c795ef7p-54; 0x123f44f445dee1p-58; 0xddfd0e0f517d9p-62]);
  (5%nat, -3, [1; 0; 0; 0; 0; 0]);
  (9%nat, 0x1ffffffffffffp-49, [0x1ce5c4330b2931p-294; 0x120f9a9fe6f9a7p-241; 0x120f9a9fe6f985p-191; 0x483e6a7f9be55p-140; 0xfcda74bea19dbp-96; 0xfffffffffff03p-52])]);
(1%nat, [0; 0; 0x13p-6; 0x844cf2694b217p-52; 0xa3edf41f67341p-52; 0x2fp-6; 1; 1],
 [(1%nat, 0, [1; 0]);
  (5%nat, 1, [0; 1]);
  (4%nat, 0xa3edf41f67341p-52, [1; 0]);
  (2%nat, 0x1f50d507086f5p-50, [0x10000000000005p-55; 0x1bffffffffffffp-53]);
  (2%nat, 0xf6280ffb1cc35p-53, [0x14f791a477a8a3p-55; 0x1ac21b96e215d7p-53]);
  (1%nat, -1, [1; 0]);
  (5%nat, 0xffffffffffffdp-52, [0xb4b4b4b4b4b4bp-100; 0x1fffffffffffe9p-53])]);
(1%nat, [0; 0; 0x1p-6; 0x1ea55c98156e1fp-58; 0x1ea55c98156e1fp-58; 0x10b3ea9bf64f57p-54; 1; 1],
 [(1%nat, 0, [1; 0]);
  (5%nat, 1, [0; 1]);
  (4%nat, 0x1ea55c98156e1fp-58, [1; 0]);
  (1%nat, 0x7p-9, [0x1p-3; 0x7p-3]);
  (5%nat, 0x13c36bab1b479fp-53, [0x8476b041278efp-52; 0x1ee253efb61c47p-54]);
  (1%nat, -1, [1; 0]);
  (5%nat, 0x3ffffffffffffp-50, [0x15a67c00614b75p-102; 0x1ffffffffffff5p-53])]);
(1%nat, [0; 0; 0x1p-2; 0xcce3d254f589fp-52; 1; 1],
 [(1%nat, 0, [1; 0]);
  (3%nat, 1, [0; 1]);
  (3%nat, 0xcce3d254f589fp-52, [1; 0]);
  (2%nat, 0xbb47580a56d8bp-52, [0x8000000000001p-54; 0x1bffffffffffffp-53]);
  (2%nat, 0x13a1826d605a31p-53, [0x15bb9a8d6a3e09p-54; 0x152232b94ae0fbp-53]);
  (1%nat, -1, [1; 0]);
  (3%nat, 0xffffffffffffdp-52, [0xf06c1a89d8f7p-96; 0xffffffffffff1p-52])]);
(1%nat, [0; 0; 0x1ffffffffffffdp-53; 0xfffffffffffffp-52; 0xfffffffffffffp-52; 1; 1],
 [(1%nat, 0, [1; 0]);
  (4%nat, 1, [0; 1]);
  (4%nat, 0xfffffffffffffp-52, [1; 0]);
  (4%nat, 0x1fffffffffffffp-53, [0x1p-1; 0x1p-1]);
  (1%nat, 0x487afb7c82a39p-51, [0x1bc28241beae35p-54; 0x90f5f6f905473p-52]);
  (1%nat, -1, [1; 0])]);
(1%nat, [0x1p-2; 0x1p-1; 1; 0x3p-1; 0x7p-2],
 [(1%nat, 0x1p-1, [1; 0]);
  (2%nat, 0x3p-1, [0; 1]);
  (2%nat, 1, [1; 0]);
  (2%nat, 0x5p-2, [0x1p-1; 0x1p-1]);
  (2%nat, 0x11af7822bfae3dp-52, [0x65087dd4051c3p-51; 0x1af7822bfae3dp-51]);
  (1%nat, -0x1p-1, [1; 0]);
  (2%nat, 0xbffffffffffffp-51, [0x1p-50; 0x3ffffffffffffp-50])]);
(1%nat, [0; 0; 0x3p-537; 0x14efa75548231p-580; 0x1p-531; 0x1p-531],
 [(1%nat, 0, [1; 0]);
  (3%nat, 0x1p-531, [0; 1]);
  (3%nat, 0x14efa75548231p-580, [1; 0]);
  (3%nat, 0xb28d9354f8f57p-583, [0x7p-3; 0x1p-3]);
  (3%nat, 0x1f9d700f2768e1p-584, [0x11d12623a69419p-57; 0xf7176cee2cb5fp-52]);
  (1%nat, -0x1p-531, [1; 0]);
  (3%nat, 0x1ffffffffffffdp-584, [0x22b5268faf81fp-99; 0x1ffffffffffff7p-53])]);
(1%nat, [0x1p40; 0x1p40; 0x400000000003p-6; 0x200000000014fp-9; 0x10000000001p0; 0x10000000001p0],
 [(1%nat, 0x1p40, [1; 0]);
  (3%nat, 0x10000000001p0, [0; 1]);
  (3%nat, 0x200000000014fp-9, [1; 0]);
  (1%nat, 0x2000000000009p-9, [0x5p-3; 0x3p-3]);
  (3%nat, 0x4000000000377p-10, [0x18c4b35839da65p-54; 0x139da653e312cdp-53]);
  (1%nat, 0xffffffffffp0, [1; 0])]);
(1%nat, [0; 0; 0x1p-67; 0x1ede7ae1d095cdp-53; 0x1fp-5; 0x7ffffp-19; 1; 1],
 [(1%nat, 0, [1; 0]);
  (5%nat, 1, [0; 1]);
  (4%nat, 0x1fp-5, [1; 0]);
  (5%nat, 0x1fffffp-21, [0x1p-2; 0x3p-2]);
  (2%nat, 0xeed7539c56635p-53, [0x210d12e011acbp-50; 0xf79768ff729a9p-53]);
  (1%nat, -1, [1; 0])]);
(1%nat, [-1; -1; -0; 0; 0x1e1b18198fc959p-57; 0x9f1977de41891p-52; 1; 1],
 [(1%nat, -1, [1; 0]);
  (5%nat, 1, [0; 1]);
  (5%nat, 0x9f1977de41891p-52, [1; 0]);
  (4%nat, 0x421e130dee327p-53, [0x1c000000000001p-53; 0x1p-3]);
  (4%nat, 0x359d147c67f17p-51, [0xb8600de954661p-53; 0xa3cff90b55cdp-48]);
  (1%nat, -3, [1; 0]);
  (5%nat, 0x3ffffffffffffp-50, [0xa914a41e20c41p-100; 0x1fffffffffffebp-53])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x13p-6; 0x5d359ff5f027fp-52; 0x33p-6; 0x1bp-5; 0xfp-4; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (11%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (11%nat, 0xfp-4, [0x8cefdc4e38d87p-65; 0x8e70689b75ab9p-59; 0x962f4f829ad0fp-55; 0x1f81cafe1914bp-50; 0xb4531aec7e32fp-53; 0x9f40a2877ee4fp-55; 0]);
  (10%nat, 0xe7p-8, [0x1dc4bbe744d0c1p-74; 0x3fa025a4c1107p-60; 0x1e461a11f440abp-58; 0x1d2090dcb845d3p-55; 0x513deee15b885p-51; 0x690849a21e62bp-54; 0x4bfp-18]);
  (8%nat, 0x13d886d37a865p-49, [0xb6da2a51f4441p-63; 0xae26ab7955951p-58; 0xe1e6668af0a07p-55; 0x2d9138ff75721p-51; 0x34f4a75925eedp-51; 0x198c1ebc21e259p-56; 0x4b7bb9c3365fbp-57]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (11%nat, 0x1fffffffffffffp-53, [0x8cefdc4e38d87p-359; 0x1a6cf94eaaa89p-301; 0xb9ce38f11ff11p-250; 0x9d89d89d89d83p-197; 0x5fffffffffff9p-146; 0xbffffffffffebp-98; 0xfffffffffffdp-48])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x3p-5; 0xba19c0a6cabafp-53; 0xba19c0a6cabafp-53; 0xba19c0a6cabafp-53; 0xba19c0a6cabafp-53; 0xba19c0a6cabafp-53; 0xba19c0a6cabafp-53; 0x1ecf988b099e6fp-53; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (14%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (14%nat, 0x1ecf988b099e6fp-53, [0x16c00bcc26b94fp-73; 0xe5590a2bb9217p-66; 0x739aba043ac67p-60; 0xe915bb86e3d61p-57; 0x757cf4575d995p-53; 0xbd819c79e744fp-52; 0]);
  (6%nat, 0xfp-8, [0x2d9p-18; 0x1dcc5d24940995p-54; 0x1847ac8787213p-50; 0x833e03238bb9bp-54; 0x5a7421fc57245p-56; 0xfcc1d95692eddp-61; 0x8eaf47f5599f9p-65]);
  (7%nat, 0xa218be81feb07p-53, [0x681b6ef6e145dp-68; 0x1055fa86c2919fp-64; 0x1107ebfb40c4e5p-60; 0x12d3db14bb71b3p-57; 0x1723cc6a05c97fp-55; 0x1d70c0a2b1c9bfp-54; 0xa2d474824b8edp-53]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (14%nat, 0x3ffffffffffffp-50, [0x1018e4a9dd11fdp-344; 0x7af47bdcef42dp-291; 0xc3a8b528b9215p-241; 0x53070d5362d9fp-190; 0x13d17e265813d7p-143; 0x142f069dfb693fp-95; 0x7fffffffffebdp-51])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x7b83f4de96fbp-53; 0xf77dae0f275dfp-54; 0x1p-2; 0x3p-3; 0x6b6c7c4ec4a5dp-51; 0x7p-3; 0x7p-3; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (13%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (9%nat, 0x1p-2, [0x18b37959c0f40bp-59; 0x1ad6305a39e397p-54; 0x354d69df48d69p-51; 0x468d43d4e6745p-53; 0xebd66ef55b4d3p-58; 0x1c17fac1c32461p-82; 0]);
  (10%nat, 0x4648ae9d89be3p-51, [0xce10bcab95b63p-59; 0x91c00c923c45fp-55; 0x8312098b357d5p-53; 0x1c7434121f143p-50; 0x1760915c0c05b3p-55; 0x9d0809228c3f9p-56; 0x101927025b42f7p-62]);
  (7%nat, 0x3cc6610c65a0dp-52, [0x925b9ddaa5a19p-86; 0x118eabb3063965p-73; 0x15f8c9b195f299p-58; 0x1d91fda69500a1p-54; 0x6488c6787f7f9p-52; 0x3a169f31edb3dp-53; 0x54b7040ab6de5p-57]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (13%nat, 0x1ffffffffffffbp-53, [0x10b0a416a120fdp-346; 0xf2ffb54a7777dp-293; 0xb63fc7f7d9993p-241; 0x3cbfed529ddd7p-189; 0x5dbffffffffe5p-142; 0x1dffffffffff45p-98; 0x1fffffffffff1p-49])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x4e68e2d45823dp-52; 0x4e68e2d45823dp-52; 0x4e68e2d45823dp-52; 0x139a38b51608f5p-54; 0x9cd1c5a8b047bp-53; 0x139a38b51608f7p-54; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (12%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (12%nat, 0x139a38b51608f7p-54, [0xffffffffffffbp-52; 0x114c59a9f67d41p-102; 0xd81c284918c5bp-153; 0x10d973257ab759p-206; 0x42edd6ab00fefp-259; 0xc72f053264efbp-319; 0]);
  (11%nat, 0x9cd1c5a8b047bp-53, [0x7bd30d3757fdfp-109; 0x7ffffffffffffp-51; 0x115a049b799ed5p-103; 0xd72fbab62fa41p-155; 0xf3a149f069a5p-205; 0x1145a2c0c67353p-267; 0]);
  (6%nat, 0x4558ebbb3afabp-53, [0xf6b8c44eb50e3p-57; 0x125663a11f47bp-51; 0x122c1aec807a75p-54; 0x13358c80653afp-50; 0xb6bf3ee043d0fp-54; 0x73e795ebc782fp-55; 0xf509391587017p-59]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (12%nat, 0xffffffffffffdp-52, [0x663479acb8ad1p-350; 0x11b9a72e640b69p-299; 0x51f97f70eddd3p-246; 0x6518b2e0e04bdp-196; 0x8c4381880ed87p-147; 0xcf9433f78dde3p-99; 0x1fffffffffffcbp-53])]);
(6%nat, [-0xfp-2; -0x5p-1; -2; -0x5p-2; -1; -0x3p-2; -0x3p-2; 0x1p-2; 1; 0x3p-1; 0x7p-2; 2; 0xbp-2; 0xdp-2; 0xfp-2],
 [(6%nat, -0x3p-2, [0x1610e4ef473283p-56; 0x10c528482c9779p-53; 0x17611a13b2d0a3p-54; 0x31945bfcd3f8bp-55; 0xee500ee500ee5p-64; 0; 0]);
  (7%nat, 1, [0; 0x17897cbaf69c47p-63; 0x1ce01b951e2b19p-58; 0x1ae3c24379d52bp-55; 0x1f2764d3dcdfc7p-54; 0x43bbd9fec9d0bp-52; 0x9dfd130463797p-58]);
  (7%nat, 0x1p-2, [0xbc14e5e0a72fp-55; 0x114dc7ee98c559p-55; 0x31e30dca04be7p-51; 0xb36302a54646fp-53; 0x1bc0f5e55d083fp-56; 0x159d9c581bf2c9p-59; 0]);
  (6%nat, -0x5p-3, [0x13ce6505581773p-57; 0x1a7349a690ce45p-54; 0xf25af60854a03p-53; 0x49e633835bac5p-54; 0xa43414deef30bp-60; 0x351e21d70bd2bp-67; 0x159d9c581bf2c9p-77]);
  (6%nat, 0x3a2bdee22a4b9p-52, [0x34cef01ac2f47p-86; 0x1c2183c56e13bdp-60; 0x25b8a5157a8d1p-52; 0x19897568443cfbp-54; 0xad649433aab17p-53; 0x1952b5a031122fp-56; 0x4b4daa613fe3fp-57]);
  (6%nat, -0x5p-1, [0x1610e4ef473283p-56; 0x10c528482c9779p-53; 0x17611a13b2d0a3p-54; 0x31945bfcd3f8bp-55; 0xee500ee500ee5p-64; 0; 0]);
  (7%nat, 0xffffffffffff9p-52, [0x1da4587e6b74efp-353; 0xbc4be5d7b4e61p-62; 0x1ce01b951e2b6dp-58; 0xd71e121bceaa7p-54; 0x7c9d934f737f1p-52; 0x10eef67fb27417p-54; 0x13bfa2608c6ee9p-59])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x1bp525; 0x1927d80eca5f01p478; 0xf39429d79a369p479; 0x1p531; 0x1p531; 0x1p531; 0x1p531; 0x1p531; 0x1p531; 0x1p531],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (9%nat, 0x1p531, [0; 0; 0; 0; 0; 0; 1]);
  (7%nat, 0x1bp525, [0xaef11e7b3dce3p-57; 0xbcf6a27dd6ebp-50; 0x5cad3ddf9fae9p-52; 0x4c2e3ccd0df9dp-52; 0xeee38aba6e705p-55; 0x124b89a2d381afp-58; 0]);
  (9%nat, 0xfe72853af346dp479, [0x123e5a1ed5fba3p-89; 0x88b895e10b0afp-78; 0xd3688103edb55p-70; 0xab6a88c102e5bp-62; 0x15d61d6e38ce83p-57; 0x1040b4354b7a5dp-53; 0xe5c87fffffffp-49]);
  (7%nat, 0xb35939557b267p479, [0xf051654497e7fp-70; 0xe26979f7b06a5p-60; 0xc6e21a6dde575p-56; 0xd313f54ce0c1p-50; 0x1967dd8ce4aa9dp-54; 0x52b9685532c4fp-52; 0x164573bb4de54dp-58]);
  (6%nat, -0x1p531, [1; 0; 0; 0; 0; 0; 0])]);
(6%nat, [0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0xee6b2801bp-6; 0xee6b280324fbp-18; 0x1dcd650079ca15p-23; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0],
 [(6%nat, 0x1dcd65p9, [1; 0; 0; 0; 0; 0; 0]);
  (9%nat, 0x3b9aca01p0, [0; 0; 0; 0; 0; 0; 1]);
  (9%nat, 0x1dcd650079ca15p-23, [0x48f9633afa1e9p-69; 0x1ab19c27dac9efp-65; 0x7a3a2cd304147p-58; 0x85b994809bf89p-54; 0x95e2636bcb553p-52; 0x11ae345d7f045fp-54; 0]);
  (7%nat, 0x77359400ef4fbp-21, [0x13a0d640be3813p-59; 0x3f8bc63707263p-53; 0xa53173eff1025p-53; 0xae6aacdbffc39p-53; 0x5704d6e764dfbp-53; 0x10eafea68606c7p-57; 0x1bbddb3ebc5201p-74]);
  (7%nat, 0xee6b2801b2133p-22, [0xa92edda897a8bp-57; 0x173e52e16456bbp-55; 0xb8b12a95070edp-53; 0x1330b2321a4773p-54; 0x1e697c1b16145p-52; 0x12d42487bf6b5dp-58; 0xe779608fb0741p-100]);
  (6%nat, 0x3b9ac9ffp0, [1; 0; 0; 0; 0; 0; 0])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x1p-157; 0x1808ecf79bf66fp-53; 0x18742a6447a4fdp-53; 0x7ffffffffffffp-51; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (10%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (8%nat, 0x1808ecf79bf66fp-53, [0x19580a36b85dfp-78; 0x84c3f109def81p-59; 0xc49c1076a9321p-56; 0xda7eadc316679p-54; 0x1afe64b4e54d5p-50; 0xa026f197a1ba9p-53; 0]);
  (8%nat, 0x181654a5316c41p-53, [0x16bf9a96f2c71p-79; 0xff3a5aefc149dp-60; 0xbf867e266fcedp-56; 0xd7ad0ec894795p-54; 0xd7f866c21d575p-53; 0xa241cd5937a8fp-53; 0x1b0088faeda04fp-92]);
  (9%nat, 0x1919dd680a1de1p-53, [0xe03a7d955322dp-61; 0xda3bc4fc59d81p-57; 0xa000a9747a5edp-54; 0x1a369fe0e29fa3p-54; 0xcfb9507f08b9p-49; 0x6abcae07f49cdp-64; 0x1ab91256a6534fp-74]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (10%nat, 0xfffffffffffffp-52, [0x11094f330f6581p-309; 0xbb666731a95c7p-254; 0xd0b20a317c9b3p-201; 0x763095723acffp-148; 0x111839dc74461fp-100; 0xfbfffffffffefp-52; 0x1p-6])]);
(6%nat, [-1; -1; -1; -1; -1; -1; -1; -0; 0; 0x7p-6; 0x1dp-6; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (10%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (9%nat, 0x7p-6, [0xf9a479eb844e1p-59; 0x3a72538d629ebp-52; 0xf3f1ffa694d1fp-53; 0x12516be2ba74c7p-54; 0xb2e126a8a3287p-61; 0x90e34f72c234fp-66; 0]);
  (9%nat, 0x19p-7, [0x16372af97d5e11p-62; 0x1133df9919bd49p-55; 0xdd7f9698c4c9dp-53; 0x1a7136d23499a5p-54; 0x11c9ce7599da65p-58; 0x904db3febf65p-57; 0x8c552fb8e41cdp-70]);
  (6%nat, -0xfbfcb4e08df41p-52, [0xe8d8cbd231d15p-52; 0x163f93e875225fp-56; 0x1c6751d09457fp-57; 0x1171ffe9b02ed9p-66; 0x92f5e33a31aebp-72; 0x7794258ec13c5p-80; 0xa1e468bc8c211p-90]);
  (6%nat, -3, [1; 0; 0; 0; 0; 0; 0]);
  (10%nat, 0x1ffffffffffff9p-53, [0x1d7c68324d3fc5p-355; 0xca308158ed22dp-300; 0x906bca1af2867p-247; 0x6e08fb823ee03p-196; 0x2f286bca1af25p-145; 0x4ccccccccccc5p-97; 0x1fffffffffffb5p-53])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x1a88699eb0901dp-55; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (7%nat, 0x1a88699eb0901dp-55, [0x14089489131ef9p-54; 0x1a316aeed38eedp-54; 0x1b65a821516f41p-55; 0xe540856b093fbp-56; 0x1df94b5194114bp-60; 0x645347e2534fdp-62; 0]);
  (6%nat, 0x1a88699eb0901dp-57, [0x16c80000000003p-55; 0x16264ab1f8ec95p-53; 0x1e9eb22819c9b7p-56; 0x14106022b67f33p-59; 0xe224cf3b339bbp-63; 0x298624deedbc5p-66; 0xc8a68fc4a69fbp-75]);
  (7%nat, 0x59c1cb4dd89a7p-51, [0x1d67112c63f22bp-63; 0x1965cb989c07dfp-59; 0x12266721591705p-56; 0xda9941fdf72d1p-54; 0x5a4301208ecabp-52; 0x951a704002533p-53; 0x1df70f1259c117p-57]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (7%nat, 0x3ffffffffffffp-50, [0x142f126866de41p-352; 0xf234dce4d26adp-299; 0x12ec2141e07053p-248; 0x193ad7028095bdp-198; 0x25d84283c0e09p-145; 0xf234dce4d269bp-99; 0x1fffffffffffc3p-53])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x7p-5; 0x21a535aa46a9p-46; 0x8939c0a9c92b1p-52; 0x13p-5; 0x13p-5; 0x13p-5; 0xbb9809e54edd7p-52; 0xbb9809e54edd7p-52; 0xbb9809e54edd7p-52; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (15%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (9%nat, 0x8939c0a9c92b1p-52, [0x1f6cc93bb30ef3p-66; 0x12b904957fd3f5p-60; 0x427303f680a6dp-54; 0x116836a24bd4f3p-53; 0x62ed8c7106cf3p-52; 0x920353758ea89p-68; 0]);
  (15%nat, 0x3109422a29407p-50, [0x4163822846a27p-53; 0xbb48466969b59p-53; 0x5e06f45a73adp-48; 0x117053ae5a1383p-55; 0xb7bfffffffff5p-60; 0x29ffffffffffdp-62; 0x1fffffffffffd3p-71]);
  (12%nat, 0xaaf187d910627p-52, [0x1608715ee73cd9p-62; 0x14d1201d9bb589p-57; 0x16b3b0e5a76b0dp-55; 0x26ccde8e22ac1p-50; 0x9de20c0853c3dp-54; 0x13c0ea8ae26b65p-58; 0x1dda4187bb0915p-63]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (15%nat, 0xfffffffffffffp-52, [0x186dd196afd6dfp-355; 0xee2ebb7d326edp-301; 0xf1e7766b27385p-249; 0x83080acf5fe91p-197; 0xd2141670f0b07p-148; 0xb3a21333f448bp-99; 0x1fffffffffffd3p-53])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x3p-3; 0xdb36c03ef511fp-53; 0xdb36c03ef511fp-53; 0xdb36c03ef511fp-53; 0xdb36c03ef511fp-53; 0xdb36c03ef511fp-53; 0xdb36c03ef511fp-53; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (13%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (7%nat, 0x3p-3, [0x1eeb01e7e2a64fp-68; 0x110aab44e74f8fp-62; 0xf0773a8900dcbp-58; 0x6a08a3f9250bfp-54; 0x1760bc8298eeefp-54; 0x107e5dd5ff9c4dp-53; 0]);
  (13%nat, 0x76d9b601f7a89p-51, [0x1ffffffffffff7p-71; 0xa7ffffffffffdp-64; 0x16f7fffffffffbp-61; 0x6b2ffffffffffp-56; 0x8caefffffffffp-54; 0x189e9fffffffffp-54; 0x1cb91000000001p-54]);
  (13%nat, 0x3ca172fe6ccd5p-51, [0x4dcf99a32311dp-51; 0x50c3a43459081p-52; 0x8bb74befe4423p-55; 0x80e7d9aaa86f5p-58; 0x85cc590577761p-62; 0x12845159b1cb17p-68; 0x11158ac5804a03p-74]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (13%nat, 0x1ffffffffffffbp-53, [0x6d168524f98ddp-350; 0x12b6eaa853cfdbp-299; 0x559d67bd78d7p-242; 0xd0e3ef70c75dp-193; 0x11eb03e84b2c23p-148; 0xd1d893e51f179p-99; 0x1fffffffffffcfp-53])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x1ffffffffffffdp-53; 0xfffffffffffffp-52; 0x1fffffffffffffp-53; 0x1fffffffffffffp-53; 0x1fffffffffffffp-53; 0x1fffffffffffffp-53; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (12%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (12%nat, 0x1fffffffffffffp-53, [0x15555555555555p-55; 0x9555555555555p-52; 0x1p-2; 0; 0; 0; 0]);
  (8%nat, 0xfffffffffffffp-52, [0x4000000000001p-263; 0x12000000000003p-210; 0xf800000000001p-156; 0x31p-57; 0xfaaaaaaaaaaa9p-52; 0x15555555555555p-58; 0]);
  (6%nat, 0xcf75493b70fefp-52, [0x185e539953f81bp-67; 0x9c38097e774cfp-61; 0x1a147b8db57e53p-59; 0x949d440ab3f95p-55; 0x7717188cf1ea9p-53; 0x1972c97b46ad7p-50; 0x12207b828b2ffdp-54]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0])]);
(6%nat, [-4; -0xfp-2; -0xfp-2; -0xbp-2; -0xbp-2; -1; -0x1p-1; 0x3p-2; 0x3p-2; 1; 1; 0x5p-2; 0x5p-2; 0x3p-1; 2; 0xbp-2; 0xfp-2; 0xfp-2; 4],
 [(6%nat, -0x1p-1, [0x732da81d43b73p-58; 0x138a07f2adc5efp-56; 0x153fd975b02aedp-54; 0xca22f6ac352cbp-53; 0xc13849da4c243p-54; 0x4a4dc96ee0129p-60; 0]);
  (10%nat, 0x5p-2, [0; 0; 0x71c71c71c71c7p-56; 0xdfa4fa4fa4fa5p-53; 0x1eb73497dbc6e1p-54; 0x6e4ed7a1025ffp-55; 0x1a98ef606a63bdp-62]);
  (10%nat, 1, [0x1041041041041p-56; 0x191b488ff6b647p-56; 0x2b3f463d886adp-50; 0xd27d27d27d27dp-54; 0x11111111111111p-58; 0; 0]);
  (10%nat, 0x9p-3, [0x1041041041041p-62; 0x13fdad91b488ffp-60; 0x45bc14e5e0a73p-52; 0x46c3333333333p-51; 0x156988e1b2ad73p-55; 0x526f239f1c05bp-59; 0x1a98ef606a63bdp-68]);
  (6%nat, -0x365b527f0fcfdp-51, [0x27a9163dca061p-57; 0x1e58af542fe0e1p-57; 0x982baea2dd8bfp-53; 0x1a2cdaf50a68ffp-54; 0x1d1051c04febb3p-55; 0x563c5a6860a5bp-59; 0x48f0bcc9427e1p-76]);
  (6%nat, -0x9p-2, [0x732da81d43b73p-58; 0x138a07f2adc5efp-56; 0x153fd975b02aedp-54; 0xca22f6ac352cbp-53; 0xc13849da4c243p-54; 0x4a4dc96ee0129p-60; 0]);
  (10%nat, 0x13ffffffffffffp-52, [0x1041041041041p-356; 0x36db6db6db6dbp-302; 0x1c71c71c71c747p-58; 0xdfa4fa4fa4fa9p-53; 0x3d6e692fb78dbp-51; 0x1b93b5e84097e1p-57; 0x1a98ef606a6395p-62])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x3509286612f09p472; 0x841cdc4a68a5dp477; 0xa971e3491831bp477; 0x19p525; 0x1p531; 0x1p531; 0x1p531; 0x1p531; 0x1p531; 0x1p531; 0x1p531],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (10%nat, 0x1p531, [0; 0; 0; 0; 0; 0; 1]);
  (9%nat, 0xa971e3491831bp477, [0x61ace4a1f950dp-54; 0x136f2d5843374bp-53; 0x81d896afd8bc7p-53; 0xa924dd0ecdbd5p-56; 0x4e5ddf9fc6a01p-59; 0x1cb53ca8899bfdp-74; 0]);
  (6%nat, 0x173401aca8493fp469, [0x1p-18; 0x1e546d02df5d83p-53; 0x1a46882beb7a1fp-57; 0x1c6feb2c02d74fp-63; 0xcfcde1795a801p-70; 0x127c955bd901bp-77; 0x1507eeec9d00adp-93]);
  (9%nat, 0x8ead2d5c8c3bp482, [0x2f41b94ffabp-51; 0x50f207193b797p-52; 0x1b308258ac16c3p-54; 0xd9fb22b6606f9p-54; 0x16164fb0111623p-57; 0x187e16a4fa1e55p-62; 0xc1989fd359927p-67]);
  (6%nat, -0x1p531, [1; 0; 0; 0; 0; 0; 0]);
  (10%nat, 0x3ffffffffffffp481, [0x121741384b7fdp-347; 0x1b22e1d4713fb1p-299; 0x87ae6926363e5p-246; 0x1693b2deee632dp-197; 0x75fc238194e93p-146; 0x13b13b13b13af1p-99; 0xfffffffffffd9p-52])]);
(6%nat, [0x1p40; 0x1p40; 0x1p40; 0x1p40; 0x1p40; 0x1p40; 0x1p40; 0x10000000000007p-12; 0x1000000000021p-8; 0x8000000000153p-11; 0x400000000019p-6; 0x10000000001p0; 0x10000000001p0; 0x10000000001p0; 0x10000000001p0; 0x10000000001p0; 0x10000000001p0; 0x10000000001p0],
 [(6%nat, 0x1p40, [1; 0; 0; 0; 0; 0; 0]);
  (10%nat, 0x10000000001p0, [0; 0; 0; 0; 0; 0; 1]);
  (8%nat, 0x1000000000021p-8, [0x118cac86feae73p-63; 0x1e00a935d9cdc7p-55; 0x134648246afe3p-49; 0x9703ea6f36fd9p-54; 0x3c5eb9579abc1p-56; 0x89b39a7c29a61p-62; 0]);
  (8%nat, 0x1000000000025bp-12, [0x118cac86feae73p-69; 0x4df6f735074bfp-53; 0x9eb0b5a5b7945p-52; 0xcda3f82b3ab55p-54; 0xd3a3deaf5cb3p-53; 0x13494f307ed823p-62; 0x1d54ff72c2599fp-80]);
  (9%nat, 0x100000000002d7p-12, [0x11927606254df5p-56; 0x966acb887020dp-52; 0x1251aeff09ad99p-54; 0x6e6a3d076c4afp-55; 0x77496e2f0f7e9p-59; 0x13fbea68571b63p-71; 0x11b0eca02714ffp-87]);
  (6%nat, 0xffffffffffp0, [1; 0; 0; 0; 0; 0; 0])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x1p-97; 0xebc67f454172fp-54; 0x9p-4; 0x3ffp-10; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (10%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (7%nat, 0x1p-97, [1; 0x15b7307f2b3361p-145; 0x269b00e213e99p-237; 0x9a92a8325c3d5p-336; 0x9a92a8325c3d5p-434; 0x1eea21a3ac0c43p-535; 0]);
  (10%nat, 0x7ffp-11, [0x17c16041333f43p-107; 0x105280795cb731p-93; 0x122a5aca9cfe7p-77; 0x523d1ba4ab983p-68; 0x92fc28a64baa3p-59; 0x3eb66d5a2085p-46; 0x1p-6]);
  (8%nat, 0x7fe0078033fadp-53, [0x666b850454cbdp-55; 0x1a8d122e15b74bp-54; 0x5d9b287c0aa4dp-52; 0x48765a08122c5p-53; 0xd5a030e196789p-57; 0x1ebbe756a5898bp-62; 0x151c23916fadf3p-83]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0])]);
(6%nat, [-1; -1; -1; -1; -1; -1; -1; -0; 0; 0x11p-6; 0x3dp-6; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (10%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (10%nat, 0x3dp-6, [0x14ae4c415c9883p-76; 0x108781e9847635p-68; 0x29e4d7cfd9607p-59; 0x683e54337bfd7p-56; 0x10447f593daea7p-54; 0xb81549e52e767p-52; 0]);
  (6%nat, -0x1p-3, [0x1p-18; 0x15p-17; 0x1339aaadb24207p-58; 0x90fb6094455bdp-53; 0x1aea81f822e8bp-50; 0xed81edfe069d1p-54; 0xb9ea1aa637791p-56]);
  (9%nat, 0x4b4aaf16bd19bp-52, [0x9036a4ea11657p-57; 0x96e81c5d4695fp-54; 0xcb67e070fd6ddp-53; 0x67d39a8f9407dp-52; 0x1e54c0e54150e5p-58; 0x14f1160b8bbe11p-61; 0x1f3cbce8f26fefp-81]);
  (6%nat, -3, [1; 0; 0; 0; 0; 0; 0]);
  (10%nat, 0x1ffffffffffffp-49, [0x7432d63dbb01dp-342; 0x15c9882b931029p-291; 0x1b3bea3677d3e3p-240; 0x913f8bcd29bdp-185; 0x6cefa8d9df4afp-140; 0x1ffffffffffc71p-95; 0x7fffffffffdffp-51])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x1db1a4467789d3p-54; 0x1a30041f583811p-53; 0x1c6729ae379423p-53; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (8%nat, 1, [0; 0; 0; 0; 0; 1]);
  (7%nat, 0x1a30041f583811p-53, [0x14547be8de8f71p-66; 0x11cae41e81c289p-58; 0x58706f82c2abdp-53; 0x916bd1934ca53p-52; 0xf790a212dd729p-54; 0]);
  (6%nat, 0x175a37a0511b47p-53, [0x900dc624a5ffp-62; 0x8e0e5c224b8bfp-59; 0x176843a8353b83p-56; 0xb672ec35211p-45; 0x7d9004b05e8f9p-52; 0xeafe49d7e833bp-56]);
  (5%nat, 0x6011e3851e5d3p-52, [0x217651f828d75p-61; 0xdad6e570cae1bp-55; 0x581c44ef072e3p-52; 0x60425f0b57269p-52; 0x134736e471deb7p-55; 0x169d5996a1f493p-58]);
  (5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (8%nat, 0x7ffffffffffffp-51, [0x16d7bbc410f795p-301; 0x7236aad454d5bp-246; 0x7236aad454d57p-194; 0xf4e38447512d5p-145; 0x163d99fd521755p-98; 0x7ffffffffffd3p-51])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x5p-6; 0x16bba245c13d13p-55; 0x16bba245c13d13p-55; 0x7p-5; 0x7p-5; 0x7p-5; 0x7p-5; 0x13371fa0e25e39p-53; 0x179b458d696e8bp-53; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (14%nat, 1, [0; 0; 0; 0; 0; 1]);
  (14%nat, 0x179b458d696e8bp-53, [0x32e275becf12bp-55; 0x162155e1619995p-55; 0x6b19d7b61aa8dp-52; 0xbd6e1a3580db3p-53; 0x72041690fa833p-57; 0]);
  (12%nat, 0x102957b8a9c6abp-53, [0x1ce2dcf144c02bp-63; 0x109cd501accc21p-56; 0x6550f9b7be287p-52; 0x5fa9e41aa14b3p-52; 0x127c0807e1f5e1p-55; 0xa6ceec49a961bp-57]);
  (8%nat, 0x6a9bc00ccec0dp-53, [0x5f55de1d94289p-67; 0x42cae5fecac5dp-60; 0x4747184e8f4c7p-55; 0xb0095f63ae07fp-53; 0x13240907228e3fp-53; 0xb5d36f30f3523p-57]);
  (5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (14%nat, 0xffffffffffffdp-52, [0x12ff01f5264eadp-300; 0xc5e054644f089p-247; 0xce1f029327a89p-196; 0x1ad6b455d3d48dp-147; 0xe4bfcf2a5f2b5p-98; 0x1fffffffffff8fp-53])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x1p-3; 0x1p-2; 0x1p-2; 0x1p-2; 0x1p-1; 0x3p-2; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (11%nat, 1, [0; 0; 0; 0; 0; 1]);
  (11%nat, 0x3p-2, [0x25ed097b425edp-55; 0x8e38e38e38e39p-54; 0x3p-3; 0x19ed097b425edp-50; 0x1p-4; 0]);
  (6%nat, 0x5p-5, [0xf3p-14; 0x37bp-13; 0x26dp-11; 0xf4ceaaaaaaaabp-53; 0x18506666666667p-56; 0x11111111111111p-66]);
  (10%nat, 0x12ea2a97b9c63fp-53, [0xaa09e3a6543d5p-59; 0x196d2fa9ba68a9p-55; 0x19abe6b894001p-50; 0x9ddabbff8ff77p-53; 0x161a4840f625adp-56; 0x34978460c935fp-61]);
  (5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (11%nat, 0x1ffffffffffff9p-53, [0x9b9ed097b425fp-298; 0x14d78e38e38e3p-243; 0x4775555555551p-194; 0xf4fffffffffe7p-146; 0x117fffffffffd3p-98; 0x7ffffffffffddp-51])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0xc7f03e0b2b269p-52; 0xc7f03e0b2b269p-52; 0x18fe07c16564d3p-53; 0x18fe07c16564d3p-53; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (9%nat, 1, [0; 0; 0; 0; 0; 1]);
  (9%nat, 0x18fe07c16564d3p-53, [0xe03f07d353655p-54; 0x18fe07c16564d3p-53; 0x1f473443e97ff3p-153; 0x5f381d519d88dp-203; 0; 0]);
  (9%nat, 0xd5f42e88605cfp-52, [0x1a9b7a8db3052fp-57; 0x4a59215c933ebp-51; 0x8700000000001p-53; 0xb400000000001p-55; 0x1dfffffffffffp-55; 0x3fffffffffffdp-60]);
  (5%nat, 0x173ba54df3860bp-53, [0xe80117268c177p-71; 0x1deb730b84d3fp-62; 0x18b1c6d6d92fa5p-61; 0x1461b845837d5p-53; 0x1a8d47d480dab5p-54; 0x8accde779e47p-48]);
  (5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (9%nat, 0xfffffffffffffp-52, [0xd967a88d1642fp-303; 0x87e0c9582de9bp-248; 0xee0c494c09d5dp-198; 0x6842ae37b4ffbp-147; 0x16d50102607153p-100; 0x1fffffffffffd3p-53])]);
(5%nat, [0; 1; 2; 3; 4; 5; 6; 7; 8; 9; 10; 11],
 [(5%nat, 5, [0x11111111111111p-59; 0x1bbbbbbbbbbbbbp-55; 0x11999999999999p-53; 0x1bbbbbbbbbbbbbp-55; 0x11111111111111p-59; 0]);
  (5%nat, 6, [0; 0x11111111111111p-59; 0x1bbbbbbbbbbbbbp-55; 0x11999999999999p-53; 0x1bbbbbbbbbbbbbp-55; 0x11111111111111p-59]);
  (5%nat, 0x17p-2, [0x11111111111111p-69; 0x19fdddddddddddp-58; 0xa7f9999999999p-53; 0x8507777777777p-52; 0xffd1111111111p-55; 0x40ccccccccccdp-59]);
  (5%nat, 0x155ff2732c4d3dp-50, [0x109ff2947b8cf3p-62; 0x1908a26647eaa1p-56; 0x1f9e198fe3817dp-54; 0xbde29dc89caa7p-53; 0x12911441d945d7p-57; 0x14f454e94899edp-67]);
  (5%nat, 4, [0x11111111111111p-59; 0x1bbbbbbbbbbbbbp-55; 0x11999999999999p-53; 0x1bbbbbbbbbbbbbp-55; 0x11111111111111p-59; 0]);
  (5%nat, 0x17ffffffffffffp-50, [0x11111111111111p-309; 0x8888888888893p-58; 0x1bbbbbbbbbbbc9p-55; 0x8cccccccccccdp-52; 0x1bbbbbbbbbbbbp-51; 0x111111111110fdp-59])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x1p531; 0x1p531; 0x1p531; 0x1p531; 0x1p531; 0x1p531],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (5%nat, 0x1p531, [0; 0; 0; 0; 0; 1]);
  (5%nat, 0x1p530, [0x1p-5; 0x5p-5; 0x5p-4; 0x5p-4; 0x5p-5; 0x1p-5]);
  (5%nat, 0x194d1b2e7a7e6bp478, [0x696268ebd0b1fp-62; 0xf8c5705a5a2a7p-59; 0xeae68830842b5p-56; 0x6ee6ce7376f6bp-53; 0xd16fa474a5d49p-53; 0x9e34f51bf35e5p-53]);
  (5%nat, -0x1p531, [1; 0; 0; 0; 0; 0]);
  (5%nat, 0x3ffffffffffffp481, [0x1p-250; 0x13fffffffffffbp-250; 0x9fffffffffffbp-198; 0x13fffffffffff1p-149; 0x4fffffffffffbp-98; 0x3fffffffffffbp-50])]);
(5%nat, [0x1p40; 0x1p40; 0x1p40; 0x1p40; 0x1p40; 0x1p40; 0x10000000001p0; 0x10000000001p0; 0x10000000001p0; 0x10000000001p0; 0x10000000001p0; 0x10000000001p0],
 [(5%nat, 0x1p40, [1; 0; 0; 0; 0; 0]);
  (5%nat, 0x10000000001p0, [0; 0; 0; 0; 0; 1]);
  (5%nat, 0x40000000001p-2, [0xf3p-10; 0x195p-10; 0x87p-9; 0x2dp-9; 0xfp-10; 0x1p-10]);
  (5%nat, 0x10000000000c25p-12, [0x353e50db0b92bp-60; 0x68d240b4af645p-57; 0x14a2e896bb9fbbp-56; 0x1040393c577291p-54; 0x33307e571a32fp-51; 0x101fd95ccc6a5bp-54]);
  (5%nat, 0xffffffffffp0, [1; 0; 0; 0; 0; 0])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x1p-92; 0x173471e371e7b5p-57; 0x13169a58b51f65p-56; 0x3ffp-10; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (9%nat, 1, [0; 0; 0; 0; 0; 1]);
  (6%nat, 0x1p-92, [1; 0x5841e28b00da7p-136; 0x6ef7a26726df3p-224; 0x12833be0292f7fp-318; 0x12833be0292f7fp-412; 0]);
  (6%nat, 0xa26f1d381d55fp-56, [0x8000000000005p-66; 0xea8a1bb5c0869p-56; 0x6e68728104b41p-51; 0x13dbc641833549p-56; 0x5365cc31b06bdp-59; 0x1e768b3f9557d3p-68]);
  (8%nat, 0xbe3eea353e4bdp-53, [0x1c522645181ac1p-56; 0x14142095f46913p-54; 0xb1de0a1bfdb15p-53; 0xbc349f02dcc4dp-54; 0x540e37ea382f5p-55; 0xdf639719312afp-60]);
  (5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (9%nat, 0x3ffffffffffffp-50, [0x121c23a81831f5p-292; 0xb5196490f1cf3p-239; 0x16a32c921e3317p-189; 0x159c8675f53e25p-139; 0x13ffffffffd7f5p-90; 0xfffffffffbp-40])]);
(5%nat, [-1; -1; -1; -1; -1; -1; -0; 0; 0x1p-4; 0xd55f7fc5dc91fp-53; 1; 1; 1; 1; 1; 1],
 [(5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (9%nat, 1, [0; 0; 0; 0; 0; 1]);
  (9%nat, 0xd55f7fc5dc91fp-53, [0x1f99ee758a57ddp-57; 0x1a00c6a110e2c9p-54; 0x16badb87d29209p-54; 0x14064044c5dd2dp-55; 0x14dffe608519bbp-58; 0]);
  (5%nat, -0x3p-2, [0xf3p-10; 0x195p-10; 0x89ac5113f4f41p-53; 0xb39488e91a435p-55; 0x544086b16d6b7p-57; 0x15422356d2317p-60]);
  (5%nat, -0x1291a72f2eddfp-51, [0x435f8edd85f6dp-64; 0x1f04eacc364d6fp-62; 0x101eb5a9550ed3p-57; 0x98e53c491272dp-53; 0x84278ad65862bp-52; 0x4dac6518aa55dp-53]);
  (5%nat, -3, [1; 0; 0; 0; 0; 0]);
  (9%nat, 0x1ffffffffffffp-49, [0x1d42d314bf1629p-298; 0x1249c3ecf76dcfp-245; 0x1249c3ecf76dc3p-195; 0x924e1f67bb6dbp-145; 0x44949eb89fdb3p-96; 0x1fffffffffff75p-53])]);
(4%nat, [0; 0; 0; 0; 0; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (4%nat, 1, [0; 0; 0; 0; 1]);
  (4%nat, 0x1p-2, [0x51p-8; 0x1bp-6; 0x1bp-7; 0x3p-6; 0x1p-8]);
  (4%nat, 0xc36f22e96f8b3p-52, [0x19aa405d95f8a5p-61; 0xa5a1cf81bdef9p-56; 0x190d8b57343dfp-51; 0xd7935012d4ffp-49; 0x15bcf493491d79p-54]);
  (4%nat, -1, [1; 0; 0; 0; 0]);
  (4%nat, 0x3ffffffffffffp-50, [0x1p-200; 0x3ffffffffffffp-198; 0x5fffffffffffdp-148; 0x3fffffffffffdp-98; 0xffffffffffffp-48]);
  (4%nat, 0x1p-1, [0x1p-4; 0x1p-2; 0x3p-3; 0x1p-2; 0x1p-4])])].

Definition rows_4 : list (nat * list float * list (nat * float * list float)) := [
(4%nat, [0; 0; 0; 0; 0; 0x955fda788b8a5p-52; 0x1c6d8c3fdba8efp-53; 0x1c6d8c3fdba8efp-53; 0x1c6d8c3fdba8efp-53; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (8%nat, 1, [0; 0; 0; 0; 1]);
  (5%nat, 0x955fda788b8a5p-52, [0xa58f647bb776fp-56; 0xeda4c73f812f9p-54; 0x71b434ce542fdp-52; 0x122268c6840337p-54; 0]);
  (4%nat, 0x955fda788b8a5p-54, [0x51p-8; 0xfff8c7e7860efp-53; 0x148e0cddf14179p-55; 0x2cf7c56a032c5p-55; 0x122268c6840339p-62]);
  (5%nat, 0x13483513822dp-45, [0x1ff7410a0dbb9dp-58; 0x1a0c9c15ef8195p-55; 0xe2d51ba7a7a0bp-53; 0xa4fb5b7990275p-53; 0x178020353e5bp-61]);
  (4%nat, -1, [1; 0; 0; 0; 0]);
  (8%nat, 0x3ffffffffffffp-50, [0x1af864680a9aa9p-242; 0x59ddc630097c3p-189; 0xf0c1d3bff7ddfp-143; 0x8f557af6d7afdp-96; 0xfffffffffff71p-52])]);
(4%nat, [0; 0; 0; 0; 0; 0x6a86ef640e5a1p-53; 0xa9e5bb30882d5p-53; 0x487f648c6c819p-51; 0x5p-3; 0x7p-3; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (9%nat, 1, [0; 0; 0; 0; 1]);
  (5%nat, 0x6a86ef640e5a1p-53, [0x6a4625bde26d1p-55; 0x1f1d1155b7eaa7p-54; 0x18a87ad39360f5p-54; 0x274215462d07dp-53; 0]);
  (9%nat, 0xfp-4, [0x9343f105d674bp-61; 0x1309b635d7f3f7p-57; 0x45021aa0b707dp-52; 0x1425ed097b425fp-53; 0x1p-4]);
  (4%nat, 0x17d689a164a75p-51, [0x1fbed0ea2d0c75p-66; 0x195ab64027d873p-56; 0x88f4ce91d0fe9p-52; 0x1443b74f6760b5p-54; 0xc99ae3c2f1af3p-56]);
  (4%nat, -1, [1; 0; 0; 0; 0]);
  (9%nat, 0x1fffffffffffffp-53, [0x9343f105d674bp-257; 0x18997c0f357f59p-204; 0xffffffffffffbp-151; 0x1ffffffffffffp-97; 0xffffffffffffp-48])]);
(4%nat, [-0xfp-2; -0x7p-1; -0x7p-1; -0x5p-2; -0x1p-2; 0x3p-2; 0x7p-2; 2; 2; 3; 0xdp-2; 0x7p-1],
 [(4%nat, -0x1p-2, [0xe2c4a6886a4c3p-57; 0x5cd3dd2fa6bp-44; 0x8ef52b8ef52b9p-52; 0xd20d20d20d20dp-56; 0]);
  (6%nat, 2, [0; 0; 0x16c16c16c16c17p-54; 0x4e38e38e38e39p-51; 0x11111111111111p-57]);
  (5%nat, 0x3p-2, [0x1041041041041p-53; 0x2f5af5af5af5bp-51; 0x1ff8386714aa2fp-54; 0xca4587e6b74fp-51; 0]);
  (4%nat, 0x1p-2, [0xe2c4a6886a4c3p-61; 0x1368a709ff3da1p-55; 0x133aac233aac23p-53; 0x1ea9b1b78d3ffp-51; 0xca4587e6b74fp-55]);
  (5%nat, 0x1475bcfbd57765p-52, [0x19a71c9c4abd19p-62; 0xabfccb574d1fdp-55; 0xd99e5ba07bafp-49; 0xef3335683386bp-53; 0x16c406793658a1p-58]);
  (4%nat, -0x5p-1, [0xe2c4a6886a4c3p-57; 0x5cd3dd2fa6bp-44; 0x8ef52b8ef52b9p-52; 0xd20d20d20d20dp-56; 0]);
  (6%nat, 0x1ffffffffffff7p-52, [0x59b91b91b91b9p-247; 0x8199999999993p-195; 0x16c16c16c16c49p-54; 0x9c71c71c71c69p-52; 0x11111111111077p-57])]);
(4%nat, [0; 0; 0; 0; 0; 0x11p525; 0x29p525; 0x1ac7b2ea84c609p478; 0x1ac7b2ea84c609p478; 0x1p531; 0x1p531; 0x1p531; 0x1p531; 0x1p531],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (8%nat, 0x1p531, [0; 0; 0; 0; 1]);
  (6%nat, 0x29p525, [0x135897ec8bb381p-58; 0x5a3aa07b834a9p-53; 0x12b6ec65c426fdp-53; 0x1c2a934c7d1af9p-55; 0]);
  (4%nat, 0x11p523, [0x51p-8; 0x23fb04dcb5a25p-50; 0xe999ca89e5d5fp-55; 0x3ac036721b303p-57; 0x156310b7c4fb43p-65]);
  (4%nat, 0x1ba4da5e18da7p479, [0x1fc1c6ac4abbd3p-56; 0x9abe35ff332e5p-52; 0x1f051606dccf3dp-55; 0x1cac49228ba399p-58; 0x12b13f89639f89p-62]);
  (4%nat, -0x1p531, [1; 0; 0; 0; 0]);
  (8%nat, 0x3ffffffffffffp481, [0x11ccc0b28de901p-245; 0xd125d8320370fp-193; 0xe17ccd15ebb47p-144; 0x18857bbea9ed3fp-98; 0x1fffffffffff3dp-53])]);
(4%nat, [-0x1dcd65p9; -0x1dcd65p9; -0x1dcd65p9; -0x1dcd65p9; -0x1dcd65p9; -0xee6b27fefp-6; -0xee6b27fd7p-6; -0x773593fe5384dp-21; -0x773593fe5384dp-21; -0x3b9ac9ffp0; -0x3b9ac9ffp0; -0x3b9ac9ffp0; -0x3b9ac9ffp0; -0x3b9ac9ffp0],
 [(4%nat, -0x1dcd65p9, [1; 0; 0; 0; 0]);
  (8%nat, -0x3b9ac9ffp0, [0; 0; 0; 0; 1]);
  (8%nat, -0x773593fe5384dp-21, [0x673e56c801e5p-50; 0x133b0c9dac577p-49; 0x131601582732cfp-54; 0; 0]);
  (6%nat, -0x1dcd64ffa7b84dp-23, [0x187c20fe949f57p-60; 0x5be6d07487d03p-54; 0x11751a95736d65p-53; 0x16e257487e2e83p-54; 0x131601582732cfp-62]);
  (6%nat, -0xee6b27fd44d4bp-22, [0x1d69dc16f20ef9p-60; 0x19b9fe3f4f851p-52; 0x8e536ddd0dabfp-52; 0xabe4b15ecc371p-53; 0x14ceb966c9467fp-63]);
  (4%nat, -0x3b9aca01p0, [1; 0; 0; 0; 0])]);
(4%nat, [0; 0; 0; 0; 0; 0x1p-87; 0x2bp-6; 0xfp-4; 0x3fffffp-22; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (8%nat, 1, [0; 0; 0; 0; 1]);
  (6%nat, 0x2bp-6, [0x5d2a3fde04b3fp-56; 0xce26f94ad147fp-54; 0x1cf46fa1918211p-54; 0x14b477ca4956a1p-54; 0]);
  (8%nat, 0xfffffdp-24, [0xf6db6db6db6dbp-114; 0x42db68e1a1f59p-88; 0x803fe5e24ab21p-68; 0xfeff7fc015fp-44; 0x1p-8]);
  (7%nat, 0x1ed1a0bff3be5bp-53, [0x5ee715c1345b1p-64; 0x205f398d03475p-56; 0x1db8cdf4d3b1d7p-55; 0xbb50e52d8e47p-48; 0x1cc6737a783647p-58]);
  (4%nat, -1, [1; 0; 0; 0; 0])]);
(4%nat, [-1; -1; -1; -1; -1; -0; 0; 0x27p-6; 0xacf6a32e496d5p-52; 1; 1; 1; 1; 1],
 [(4%nat, -1, [1; 0; 0; 0; 0]);
  (8%nat, 1, [0; 0; 0; 0; 1]);
  (7%nat, 0x27p-6, [0xc76d120e85a05p-63; 0x173897003b1069p-55; 0xf7714d32ab8bdp-53; 0x156f4f70fc9223p-54; 0]);
  (4%nat, -0x7p-3, [0x961p-12; 0x157p-10; 0x985f665656b99p-55; 0x8f122a71183f3p-59; 0x17bb814be13e75p-66]);
  (6%nat, 0x5d69d0e5af7efp-52, [0x1e6d90f8ea67dbp-61; 0x170c51570e2f69p-56; 0x1392e5c685633p-49; 0x1018c51275e71bp-54; 0x160bff464f8ec5p-57]);
  (4%nat, -3, [1; 0; 0; 0; 0]);
  (8%nat, 0x1ffffffffffffp-49, [0x7e47606ea4583p-244; 0x1f91d81ba915edp-195; 0x5eb58852fb415p-143; 0x18a9f0d59c18d1p-98; 0x1fffffffffff3bp-53])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x5p-5; 0x3p-4; 0x131ce1b8e7e85bp-53; 0x179ad32765a739p-53; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (10%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (8%nat, 0x3p-4, [0x1a598d68c4b4f5p-55; 0x1d3aeb85be3f27p-54; 0x1218ae59d5bbabp-54; 0x690f879336947p-55; 0xdc897eb1940dp-56; 0x33f0e441ed771p-72; 0]);
  (6%nat, 0xfp-7, [0x1p-12; 0x7cbp-17; 0x827c2427430ffp-52; 0xc18e0d54c0cafp-53; 0xb7aac0c73ea0dp-55; 0x1c4d6b76d7c23bp-60; 0x1a4cbc0e749b71p-65]);
  (8%nat, 0xe23cf76c0cbfdp-53, [0xa08c8cf9b89ddp-62; 0x1160005ec3bbd5p-57; 0x120f3eeb55fc33p-54; 0x67b27abcad741p-52; 0xf2c8a9ed555cdp-54; 0x9d187684560fp-52; 0x16968bf7f2dd4fp-61]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (10%nat, 0x3ffffffffffffp-50, [0x6e730625fd195p-347; 0xa5ac8938fba5bp-295; 0x19e2f570e751d5p-245; 0x747d507c10effp-193; 0x11bf1742e6947fp-145; 0xb6f61b446b689p-97; 0x1fffffffffff49p-53])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x23836e17b7247p-51; 0x23836e17b7247p-51; 0x23836e17b7247p-51; 0x1dp-6; 0x25p-6; 0x13p-5; 0x31p-6; 0x31p-6; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (14%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (10%nat, 0x1dp-6, [0xdc22619278eebp-60; 0x1e8e3f2794c19p-53; 0xef96a38f15099p-53; 0x1591f932011c55p-54; 0x3e57d3ce29f79p-53; 0x14ecec9ff9a31dp-59; 0]);
  (11%nat, 0x4bp-7, [0x2f4efe49a3627p-77; 0xeb57e6e6eabedp-57; 0x1725beabf349bdp-55; 0x862dedb948839p-52; 0x105bcf9fa66eebp-54; 0x15e4b84d585249p-59; 0xbd6a6ea4505adp-79]);
  (9%nat, 0xe7bd6cc1152bp-49, [0x139fc1a4fce395p-107; 0x1c31cbb37e4dc1p-61; 0x1f0b1b9af57c65p-57; 0x1e142cb2b3c2f3p-54; 0x15792292748b19p-54; 0xf68c8c221bb21p-55; 0x1490a9e02507a7p-59]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (14%nat, 0x1ffffffffffffdp-53, [0xbf5e63651769bp-352; 0x1148c2a0a4eb91p-299; 0xfc0fc0fc0fc07p-247; 0xbd0bd0bd0bd01p-196; 0x13333333333319p-147; 0x1333333333330dp-99; 0x1fffffffffffb1p-53])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x3p-2; 0x3p-2; 0x3p-2; 0x3p-2; 0x3p-2; 0x3p-2; 0x7p-3; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (13%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (13%nat, 0x7p-3, [0x1p-5; 0x5p-5; 0x5p-4; 0x5p-4; 0x5p-5; 0x1p-5; 0]);
  (6%nat, 0x9p-5, [0x1e848000000001p-57; 0x6dddp-17; 0x14997p-18; 0x41ebp-16; 0x76a7p-18; 0xe3dp-17; 0x2d9p-18]);
  (6%nat, 0x8c4efd1ae4fabp-52, [0xc7a70d54bf111p-63; 0x19671dc3353265p-60; 0xac614a55b1a45p-56; 0x9bf7682bc42a3p-54; 0x13d82a3242965p-50; 0xac5ddc9307805p-53; 0x9bf44dfd1f5adp-54]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (13%nat, 0x3ffffffffffffp-50, [0x1p-287; 0x5fffffffffff9p-287; 0x3bffffffffff7p-237; 0x13ffffffffffb5p-191; 0xeffffffffffbp-139; 0x5ffffffffffd3p-95; 0x3ffffffffffdp-46])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x1ffffffffffffdp-53; 0x1ffffffffffffdp-53; 0xfffffffffffffp-52; 0x1fffffffffffffp-53; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (10%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (9%nat, 0xfffffffffffffp-52, [0x10000000000003p-213; 0x69c71c71c71c7p-155; 0x66d097b425edp-98; 0x1ded097b425ecdp-53; 0x1e06522c3f35bbp-57; 0xca4587e6b74fp-55; 0]);
  (6%nat, 0x1ffffffffffffdp-55, [0x16c80000000003p-55; 0x16c80000000001p-54; 0x97e0000000001p-53; 0x87p-10; 0x10dfffffffffffp-57; 0x11fffffffffffdp-60; 0x1ffffffffffff7p-65]);
  (6%nat, 0x4548359ecb7fp-52, [0x1ce2fd14124fbbp-53; 0x17db49a7e2b707p-56; 0x41acb87e9af05p-58; 0x181b274e7fc273p-66; 0x13e88f9beb4cdbp-72; 0x1189b1dec88119p-79; 0x66ff44f91e12dp-86]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (6%nat, 0x3ffffffffffffp-50, [0xf424000000009p-356; 0x927c000000003p-302; 0x2ff9p-212; 0x1e13fffffffff9p-200; 0x90ffffffffffbp-148; 0x9bffffffffff7p-99; 0xfffffffffffedp-52])]);
(6%nat, [-0x7p-1; -0x7p-1; -0x9p-2; -1; -0x1p-1; 0x1p-1; 0x3p-2; 1; 1; 0x5p-2; 0x3p-1; 2; 0x9p-2; 3; 4],
 [(6%nat, 0x3p-2, [0x5d5b2b0805d5bp-65; 0xd608dd459fd6bp-60; 0xe4dc47340a3a1p-55; 0x202b015ac056bp-50; 0x183efbefbefbefp-54; 0x71c71c71c71c7p-59; 0]);
  (6%nat, 1, [0; 0; 0x56b015ac056bp-55; 0x11f2747c9d1f27p-55; 0x15625625625625p-53; 0x2eeeeeeeeeeefp-52; 0x16c16c16c16c17p-60]);
  (6%nat, 0x19p-5, [0xa79756cac2017p-67; 0xe88454cce3c7bp-61; 0x15b5969bbf45cdp-56; 0x1e5f123a28a289p-54; 0x1ba2cfd12b12bp-50; 0xe6a7c16c16c17p-59; 0x16c16c16c16c17p-78]);
  (6%nat, 0x1f686d835a0b5p-49, [0x40594c3b32d67p-87; 0xb30ca2c6e5d33p-78; 0x4285804999971p-58; 0xaaaa98e4257bbp-54; 0xac4da9803a979p-52; 0x138c08cb7a57a7p-55; 0xe58881d5c005fp-60]);
  (6%nat, 0x1p-1, [0x5d5b2b0805d5bp-65; 0xd608dd459fd6bp-60; 0xe4dc47340a3a1p-55; 0x202b015ac056bp-50; 0x183efbefbefbefp-54; 0x71c71c71c71c7p-59; 0]);
  (6%nat, 0xfffffffffffffp-52, [0x5d5b2b0805d5bp-365; 0x13b13b13b13b11p-310; 0xad602b580ad7p-56; 0x8f93a3e4e8f99p-54; 0xab12b12b12b13p-52; 0x17777777777769p-55; 0x16c16c16c16bf5p-60])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0xc6a9dce92433bp-583; 0xdp-535; 0x1p-531; 0x1p-531; 0x1p-531; 0x1p-531; 0x1p-531; 0x1p-531; 0x1p-531],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (8%nat, 0x1p-531, [0; 0; 0; 0; 0; 0; 1]);
  (7%nat, 0xc6a9dce92433bp-583, [0x18750d941064cfp-75; 0x189d7d62509e41p-61; 0x27fd43f5b1249p-54; 0x18872f72beaec5p-55; 0x6b80404c57283p-52; 0x162b4835c2be69p-54; 0]);
  (6%nat, 0xc6a9dce92433bp-585, [0x16c7fffffffffbp-55; 0x17a68d2bd373f9p-54; 0xa36cb392ebfp-45; 0x70f9a6708e493p-54; 0x554378b3b1fc1p-56; 0x10e8b1ba02a78fp-61; 0x162b4835c2be6bp-66]);
  (6%nat, 0x14678f6160eab3p-584, [0x86e3a975b413fp-66; 0x18868fd16e4227p-62; 0xb8f62c6421dddp-56; 0x60f22e2bef65dp-53; 0x165a47126af205p-54; 0x13b80304d718ffp-54; 0xda513fc6939adp-55]);
  (6%nat, -0x1p-531, [1; 0; 0; 0; 0; 0; 0]);
  (8%nat, 0x3ffffffffffffp-581, [0x2fa0139875545p-345; 0x11dc07592bff93p-295; 0x1653092f76ff69p-244; 0x1dc40c3f495471p-194; 0xb298497bb7f9bp-143; 0x1fffffffffff3dp-98; 0x1fffffffffff03p-53])]);
(6%nat, [-0x1dcd65p9; -0x1dcd65p9; -0x1dcd65p9; -0x1dcd65p9; -0x1dcd65p9; -0x1dcd65p9; -0x1dcd65p9; -0xee6b27fce5589p-22; -0x3b9ac9ff3p-4; -0x3b9ac9ffp0; -0x3b9ac9ffp0; -0x3b9ac9ffp0; -0x3b9ac9ffp0; -0x3b9ac9ffp0; -0x3b9ac9ffp0; -0x3b9ac9ffp0],
 [(6%nat, -0x1dcd65p9, [1; 0; 0; 0; 0; 0; 0]);
  (8%nat, -0x3b9ac9ffp0, [0; 0; 0; 0; 0; 0; 1]);
  (8%nat, -0x3b9ac9ff3p-4, [0x43cf6ad2d83d9p-60; 0x134912492611cdp-58; 0x8422b2c863393p-54; 0x1945095b616edp-50; 0x1d316645acda2dp-54; 0xf0199236228dfp-65; 0]);
  (7%nat, -0x1dcd64ff9a5589p-23, [0xc3a8cc0d7d54dp-80; 0x1d95db4b2d0f7dp-62; 0x71a64c8598c0bp-56; 0xa410df3a68657p-54; 0x1a5ed4b4c083fdp-54; 0x65ef9b1970c2fp-52; 0xf0199236228dfp-71]);
  (6%nat, -0xee6b27ff72bfbp-22, [0x13c757f533ee6dp-54; 0xd247252338cdp-49; 0x393b3f0414a1p-48; 0x669773b7be9edp-55; 0xcad75686bbb55p-59; 0x69e88ea0d42d5p-62; 0x16e9ba37cff9fbp-69]);
  (6%nat, -0x3b9aca01p0, [1; 0; 0; 0; 0; 0; 0])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x1p-37; 0x11p-6; 0x1dp-5; 0x7ffffffp-27; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (10%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (10%nat, 0x7ffffffp-27, [0xe865ac7b7d46dp-183; 0x244fe2e5a7063p-151; 0x913f8b4dd4c47p-125; 0x913f8ae09ea47p-98; 0x1aaaaa5a7a4093p-74; 0x1fffff2aaaace5p-53; 0]);
  (9%nat, 0x1dbfffffp-29, [0xeb915713f7cffp-71; 0x1fe30253129d1bp-66; 0xdd4af985804ddp-60; 0xbfeb0461910c7p-56; 0x14abb2b7f8f52bp-54; 0x281748eb8a277p-50; 0x1fffff2aaaace5p-65]);
  (9%nat, 0x1dc5c12caabd9dp-53, [0xddcb8129e0fefp-71; 0x1e653ed114a271p-66; 0x356793d869ecfp-58; 0xbbadd06b8a445p-56; 0xa3eb828f1aebfp-53; 0x142bde8a033d51p-53; 0x26341233d24d7p-61]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (10%nat, 0x1fffffffffffffp-53, [0xe865ac7b7d46dp-339; 0x15c9882aab58f5p-284; 0xd9df519dfbea1p-229; 0x489fc5d8f6ebfp-174; 0x4fffffe555553p-122; 0xbfffff87ffff9p-75; 0xfffffe800000fp-52])]);
(6%nat, [-1; -1; -1; -1; -1; -1; -1; -0; 0; 0xad784109e954bp-55; 0x11eff96269a7dfp-54; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (10%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (10%nat, 0x11eff96269a7dfp-54, [0xd8100f6365a29p-56; 0x4d1838e5d1dddp-52; 0x883b4609f9453p-52; 0x192ccdcab1b985p-56; 0x1f0c153ece8609p-59; 0x1d2fa772f87dafp-64; 0]);
  (8%nat, 0xad784109e954bp-57, [0x1bc199aea7fa51p-70; 0x990ac3ed9ac0fp-58; 0x9d937a7bee8afp-53; 0x3d479429afd9fp-51; 0x6884deecff0afp-53; 0x4346f2a11f4dbp-70; 0x413ecccb71fddp-78]);
  (6%nat, -0x182c54fb1b6a5p-49, [0x5f2454e2a1939p-53; 0xb8d4cae54207dp-53; 0x13581545a73f19p-54; 0x1ffcc567d41e7dp-56; 0x63fa3d2c914dbp-56; 0x3215938f38a1fp-59; 0x14351dac8a8cb5p-67]);
  (6%nat, -3, [1; 0; 0; 0; 0; 0; 0]);
  (10%nat, 0x3ffffffffffffp-50, [0xc24d8219f8bf9p-353; 0x123744326f51f1p-300; 0x16c5153f0b2667p-248; 0x1e5c1c540eddd3p-198; 0x16c5153f0b2657p-148; 0x21588e7d2c34fp-96; 0x1fffffffffffbdp-53])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x155780e8e131bbp-54; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (7%nat, 0x155780e8e131bbp-54, [0x10d6d7a8e08a69p-55; 0x150fc3ff292b1dp-54; 0x1512fae8bf1cdp-50; 0x1516324fedaa7p-51; 0x5465a8d31ffdp-51; 0x10e3b545e76df3p-60; 0]);
  (6%nat, 0x4ab2432f142e1p-52, [0x3fffffffffffdp-68; 0xc1d9666231579p-54; 0x17e38f0108abd9p-54; 0x972ce418db6f1p-53; 0x77de901837fc7p-54; 0x17cf33d374e7c9p-58; 0x79475bf80a28fp-60]);
  (7%nat, 0x1f501452910671p-53, [0x14391e597212a3p-85; 0xac76dd1d19c35p-76; 0x13230d0608d863p-70; 0x2431b60d6aea5p-61; 0x133430b5a7a7c1p-59; 0x56647e1a1daedp-53; 0x1a4a9a98fd17ffp-53]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (7%nat, 0x3ffffffffffffp-50, [0x18013892e4cba9p-352; 0x900753715cc5dp-298; 0xb409284db3f71p-247; 0x1e0186b79dfe79p-198; 0x16812509b67ed3p-148; 0x900753715cc51p-98; 0x1fffffffffffb9p-53])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x109961c2982439p-55; 0x9p-6; 0x1p-2; 0x1bp-6; 0x132602ff6a21b1p-53; 0x2b02917d3a8b7p-50; 0x1725805ca2261bp-53; 0xbd20641b91e39p-52; 0xbd20641b91e39p-52; 0x188100e5100f17p-53; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (16%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (15%nat, 0xbd20641b91e39p-52, [0x12f3526237bf9bp-61; 0x1145b589da1335p-53; 0x6b7dfd3a7a511p-52; 0x137128e9ccd52dp-57; 0x109dbaf3b2d11dp-66; 0; 0]);
  (8%nat, 0x19p-7, [0x110d3688fad671p-63; 0x1028ee318496cfp-55; 0xf4172840187b1p-53; 0x5425ab0783461p-52; 0x224aa12ba7fb3p-53; 0x1a66b007092583p-63; 0x2b049cd24a7bp-62]);
  (10%nat, 0x6c53c170861dp-48, [0x191ac7bed2d141p-60; 0x342a09f56de57p-53; 0x3014bac403c39p-51; 0xba1d285291c3fp-53; 0x92dcb175173f7p-54; 0x4d430f58b4939p-57; 0x15581539f9c5edp-99]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (16%nat, 0x1ffffffffffff9p-53, [0x18137597bee47bp-343; 0x2126c3afd84a9p-288; 0x3e2114c7607c1p-239; 0xd18c1cf243d63p-192; 0xbbad1bd63ec03p-144; 0xb34b307b77117p-97; 0x1fffffffffff4dp-53])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x59664f09bbf19p-53; 0x89afa8abeed29p-53; 0xb7844dce010c9p-52; 0x1af2b8b6617927p-53; 0x1af2b8b6617927p-53; 0x1af2b8b6617927p-53; 0x7p-3; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (13%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (9%nat, 0xb7844dce010c9p-52, [0x11b115c243d7cbp-65; 0x7b52da981ebcbp-59; 0x54dd2117d4c3fp-55; 0x1f3064447b6ca5p-55; 0xfd61e1b9c7cf1p-53; 0x1ba9921b8ca3a7p-55; 0]);
  (6%nat, 0x271cc2944239bp-52, [0xfffffffffffefp-70; 0x4bb9b03cb0f43p-56; 0x1e3f1cdb2a3dfp-50; 0x18e2ef07d8ad99p-54; 0xd971348ae069fp-55; 0x1b22c1e0bdd549p-59; 0xa5da8ad5eab57p-62]);
  (6%nat, 0x921d47fb7441p-53, [0x10c38b04c73e87p-53; 0x3297112947b23p-51; 0x9fb72a16edc01p-55; 0x2eda40886a07bp-58; 0xcbfc842843175p-66; 0xe928b4b74e7efp-73; 0x370803f6eb84bp-79]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (13%nat, 0x3ffffffffffffp-50, [0x132f3b61d35865p-339; 0x1509c48b1e793bp-287; 0x7722404d35defp-236; 0x644edc96b973dp-188; 0xbe075792e5947p-142; 0x2ffffffffffe5p-94; 0x3ffffffffffdp-46])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x1ffffffffffffdp-53; 0xfffffffffffffp-52; 0x1fffffffffffffp-53; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (9%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (9%nat, 0x1fffffffffffffp-53, [0x15555555555555p-214; 0x1638e38e38e38dp-159; 0x87b425ed097b3p-104; 0x155ba781948b0dp-53; 0x9a4587e6b74fp-49; 0x1p-5; 0]);
  (6%nat, 0x24fb4f1661533p-52, [0x1918d9199832f3p-54; 0x196d16e90c5dedp-54; 0xabbae740603e3p-54; 0x1354d0b231a53dp-57; 0x9cada02216d5bp-59; 0x54a8492379da7p-62; 0x130f35f9c87d1bp-69]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0])]);
(6%nat, [-4; -4; -0xfp-2; -0xfp-2; -0xdp-2; -3; -0xbp-2; -0x5p-1; -0x7p-2; -0x7p-2; -0x3p-1; -0x3p-1; -0x1p-1; 1; 0x9p-2; 0xbp-2; 3; 0xdp-2; 0xfp-2],
 [(6%nat, -0xbp-2, [0x123456789abcdfp-62; 0xb2a1907f6e5d5p-54; 0x6ebe635dad525p-52; 0xb4a9b101767ddp-53; 0x275c97eba0dc3p-54; 0x123456789abcdfp-63; 0]);
  (11%nat, -0x1p-1, [0; 0xbc04fb20ba15dp-56; 0x628077801055bp-52; 0xcab06131be97bp-53; 0x9b796cd11fe23p-54; 0x14eee64eff0b6bp-58; 0x133cdb3f40730dp-62]);
  (7%nat, -0x5p-1, [0x10333333333333p-57; 0x19eb851eb851ebp-55; 0xfb4a1e3b7d517p-53; 0xf7cfe3649cb03p-54; 0x10c83fb72ea61dp-57; 0x123456789abcdfp-64; 0]);
  (6%nat, -0x53p-5, [0x67ae147ae147bp-69; 0x106b2c8147ae15p-56; 0x97cfc87ae147bp-53; 0x1ef9702ac5f92dp-54; 0x12992d6f8091a3p-55; 0x149c50c83fb72fp-59; 0x115c71c71c71c7p-68]);
  (7%nat, -0x841b421f39d75p-50, [0x166765ae0a771fp-65; 0xa02b47adb1cddp-59; 0x197142282635ebp-56; 0x55cdecec48b07p-52; 0xeec4c6c8a1665p-53; 0x17a0cf738834e1p-56; 0x1c84f461722fdfp-62]);
  (6%nat, -5, [0x123456789abcdfp-62; 0xb2a1907f6e5d5p-54; 0x6ebe635dad525p-52; 0xb4a9b101767ddp-53; 0x275c97eba0dc3p-54; 0x123456789abcdfp-63; 0]);
  (11%nat, -0x8000000000009p-52, [0x1273eb851eb851p-348; 0x17809f641742edp-57; 0xc500ef0020abdp-53; 0xcab06131be975p-53; 0x9b796cd11fe15p-54; 0xa7773277f859bp-57; 0x4cf36cfd01cb3p-60])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x1p531; 0x1p531; 0x1p531; 0x1p531; 0x1p531; 0x1p531; 0x1p531],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (6%nat, 0x1p531, [0; 0; 0; 0; 0; 0; 1]);
  (6%nat, 0x1p528, [0x1cb91p-18; 0xc4f5p-17; 0x8cafp-18; 0x6b3p-16; 0x2dfp-18; 0x15p-17; 0x1p-18]);
  (6%nat, 0xb42f9553ff917p478, [0x25eee5eccc467p-53; 0x1ee6002d5fcaddp-55; 0x53e4f074ec46dp-52; 0xf2f8f1d8bada7p-54; 0xc5e9b4e09a5a5p-55; 0xabf5012f56c15p-57; 0xf9023c629095dp-61]);
  (6%nat, -0x1p531, [1; 0; 0; 0; 0; 0; 0]);
  (6%nat, 0x3ffffffffffffp481, [0x1p-300; 0xbfffffffffffdp-299; 0x1dfffffffffff1p-249; 0x13fffffffffff1p-198; 0xefffffffffff1p-148; 0xbfffffffffff1p-99; 0x1fffffffffffdp-49])]);
(6%nat, [0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0],
 [(6%nat, 0x1dcd65p9, [1; 0; 0; 0; 0; 0; 0]);
  (6%nat, 0x3b9aca01p0, [0; 0; 0; 0; 0; 0; 1]);
  (6%nat, 0xee6b2803p-2, [0x1p-12; 0x9p-11; 0x87p-12; 0x87p-10; 0x4bfp-12; 0x2d9p-11; 0x2d9p-12]);
  (6%nat, 0x773594019ed15p-21, [0x1884770dc67a87p-67; 0x139f43d75d5649p-62; 0x1a2c7a7bd7fed7p-59; 0x253d8aa25209dp-53; 0x1dce03265c2443p-55; 0xcb8d431e15827p-53; 0x90ceebcab386bp-53]);
  (6%nat, 0x3b9ac9ffp0, [1; 0; 0; 0; 0; 0; 0])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x1p-54; 0x43e6948945911p-52; 0x1dp-6; 0x3ffffffffffp-42; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (10%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (10%nat, 0x3ffffffffffp-42, [0x13e8c40ad7523bp-261; 0xc717a86c68f8bp-216; 0x18e2f50d8d16a5p-174; 0x18e2f50d8d0cb9p-132; 0x12492492490769p-91; 0x1fffffffffb6dbp-53; 0]);
  (8%nat, 0xabe039ab96f55p-53, [0x17f0c6549cff0fp-63; 0x1b34a1f9e8df87p-55; 0x194a6e54d9b355p-54; 0x124751e777481p-50; 0xc0a04cb09ae45p-55; 0x185ce7aa8f9f85p-59; 0x3302dbc8d7d35p-68]);
  (7%nat, 0x2d2aff28e67edp-52, [0xb893874c63c11p-61; 0x1f222f4a0bfb53p-56; 0x119eab45b5b2c3p-53; 0x10d2d66458ca6dp-54; 0xea516b52b605bp-56; 0x18b493fa413b77p-60; 0x10733e6d9ee83p-60]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (10%nat, 0xffffffffffffdp-52, [0x1c58eb216f9495p-312; 0x715580102d9a7p-257; 0x17985943dbf8efp-207; 0xa79d94b669559p-155; 0x1ebca39f5de85dp-107; 0x8ef30d684d89dp-57; 0xfb886794bd93bp-52])]);
(6%nat, [-1; -1; -1; -1; -1; -1; -1; -0; 0; 0x1p-4; 0x7p-4; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (10%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (10%nat, 0x7p-4, [0x1ec13333333333p-59; 0x1289ca3d70a3d7p-55; 0x1e9594dd2f1aa1p-54; 0x4269460aa64c3p-52; 0xbdaca771c971p-51; 0x14f8b588e368fp-55; 0]);
  (9%nat, 0x13p-6, [0x130443acc6259p-63; 0x1d43909f666c4dp-57; 0x13bcc25ebf481p-50; 0x10c4a0228b95b1p-53; 0xc197c0b1a1f59p-55; 0x1f46a412492491p-59; 0x5p-13]);
  (6%nat, -0x6240df7df9251p-52, [0x68bc69d241b6fp-59; 0xfc3b4c1945f97p-57; 0x11f5097f544a87p-55; 0xc3640d29ae1dbp-53; 0xaffea0b20db9fp-53; 0x176609b91fbeafp-56; 0x1259c92f5869e7p-59]);
  (6%nat, -3, [1; 0; 0; 0; 0; 0; 0]);
  (10%nat, 0x3ffffffffffffp-50, [0x1e573ac901e573p-354; 0x16c16c16c16c11p-300; 0x71c71c71c71c3p-246; 0x97b425ed097abp-196; 0x38e38e38e38dfp-145; 0x1555555555552fp-99; 0xfffffffffffd5p-52])]);
(3%nat, [0; 0; 0; 0; 0xbp-6; 0x39p-6; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (5%nat, 1, [0; 0; 0; 1]);
  (4%nat, 0xbp-6, [0x14d74386a875dfp-53; 0x28641155a6049p-51; 0x21f7047dc11f7p-54; 0]);
  (3%nat, 0x21p-9, [0x1f400000000001p-55; 0xafc413db1fe95p-52; 0x11494a75b7aae7p-56; 0xe5435e50d7943p-61]);
  (4%nat, 0xd48a0af8b3357p-52, [0x19523fe1273c91p-64; 0x19d98dc67eee7bp-57; 0x17b18fa94b895dp-54; 0x12867506f62781p-53]);
  (3%nat, -1, [1; 0; 0; 0]);
  (5%nat, 0x3ffffffffffffp-50, [0x1614b36831ae93p-199; 0x847c34712a16fp-146; 0x1b6db6db6db693p-98; 0x1fffffffffff23p-53])]);
(3%nat, [0; 0; 0; 0; 0x87017e16ec2bdp-53; 0x2dp-6; 0x65f81c9a08fdfp-51; 0x33p-6; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 1]);
  (7%nat, 0x33p-6, [0xaef35786a3c55p-52; 0xa21921ee44c59p-53; 0x178239d7ebcf3fp-72; 0]);
  (3%nat, 0x87017e16ec2bdp-56, [0x15700000000001p-53; 0xa083e8627faf7p-53; 0x42e285866caafp-56; 0xfe376595d9757p-64]);
  (3%nat, 0x6bdd0f22a8315p-53, [0x10a46d5e0afe3fp-59; 0x112cae88edd285p-53; 0x19144e10add61fp-54; 0x1034c5ca18b39dp-56]);
  (3%nat, -1, [1; 0; 0; 0]);
  (7%nat, 0x3ffffffffffffp-50, [0x1462bc031aa82dp-196; 0x489fbdcb0ef6dp-144; 0x1d89d89d89d855p-99; 0x1fffffffffff8bp-53])]);
(3%nat, [0; 0; 0; 0; 0x56c3ca02d2867p-52; 0xe49722dbbaae9p-53; 0x5p-3; 0xdb6bf82020fb5p-52; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 1]);
  (4%nat, 0x56c3ca02d2867p-52, [0xeda51e9825a39p-56; 0x87c3188a05119p-52; 0x1a58a5631e250dp-54; 0]);
  (6%nat, 0x19921f4303179p-49, [0x10344876e377c1p-60; 0x10542d56d26b99p-54; 0x944b3064c871p-48; 0x2960d5b87fa91p-52]);
  (3%nat, 0x3138b3f9cc099p-52, [0x14bd6a590462b5p-56; 0x6e0bcca84f85dp-52; 0xd3f2834366241p-53; 0x99ec3ae7c82b9p-55]);
  (3%nat, -1, [1; 0; 0; 0]);
  (7%nat, 0x1ffffffffffffdp-53, [0xe395f071de359p-201; 0x1f7e7f4a07c5e3p-150; 0xfbf3fa503e2e9p-99; 0x1fffffffffffc1p-53])]);
(3%nat, [0; 0; 0; 0; 0x1ffffffffffffdp-53; 0xfffffffffffffp-52; 0x1fffffffffffffp-53; 0x1fffffffffffffp-53; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 1]);
  (5%nat, 0xfffffffffffffp-52, [0x10000000000001p-106; 0x3p-2; 0x1p-2; 0]);
  (3%nat, 0xbffffffffffffp-53, [0x1f3fffffffffffp-55; 0x1c200000000001p-54; 0x87p-9; 0x1b000000000001p-57]);
  (3%nat, 0xf13bba6eab497p-52, [0xc93f345bd2089p-64; 0x9a1b9a6aba291p-58; 0x4eac700dae35bp-53; 0xd634c59c383f7p-52]);
  (3%nat, -1, [1; 0; 0; 0]);
  (3%nat, 0x3ffffffffffffp-50, [0x1f400000000009p-205; 0x16bfffffffffffp-152; 0x11fffffffffffbp-101; 0x1fffffffffffefp-53])]);
(3%nat, [-4; -3; -0xbp-2; -0x1p-1; -0x1p-1; -0x1p-2; 0x1p-2; 0x7p-2; 0x9p-2; 0xbp-2; 0xdp-2; 0xfp-2; 4],
 [(4%nat, -0x1p-1, [0xccccccccccccdp-55; 0x1ccccccccccccdp-53; 0; 0]);
  (8%nat, 0xbp-2, [0; 0x15555555555555p-55; 0x15555555555555p-53; 0x15555555555555p-55]);
  (6%nat, 0x1p-2, [0x1p-1; 0x1ccccccccccccdp-54; 0xccccccccccccdp-56; 0]);
  (7%nat, 0x23p-4, [0xccccccccccccdp-65; 0x9133333333333p-54; 0xbf17777777777p-52; 0x1c955555555555p-56]);
  (6%nat, 0x5f3126f8cd5fbp-50, [0xafddf1cc6d905p-60; 0x14d1eff2e94d73p-55; 0x12a0303002d1bfp-53; 0x40aac0a84a699p-52]);
  (4%nat, -0xfp-2, [0xccccccccccccdp-55; 0x1ccccccccccccdp-53; 0; 0]);
  (8%nat, 0xaffffffffffffp-50, [0xccccccccccccdp-202; 0xaaaaaaaaaaabbp-54; 0xaaaaaaaaaaaabp-52; 0x15555555555535p-55])]);
(3%nat, [0; 0; 0; 0; 0x2dp525; 0x35p525; 0x1p531; 0x1p531; 0x1p531; 0x1p531],
 [(3%nat, 0, [1; 0; 0; 0]);
  (5%nat, 0x1p531, [0; 0; 0; 1]);
  (5%nat, 0x35p525, [0x65e50d79435e5p-54; 0xb9242a8c68f3fp-52; 0x16b1490aa31a3dp-55; 0]);
  (3%nat, 0x13bp522, [0x1p-9; 0x198074a75334f3p-56; 0xff3a557c37c67p-53; 0xccc4c13521cfbp-53]);
  (5%nat, 0xf00f15ffc7031p479, [0x9b0f07531adcbp-59; 0x2e059ee0e53c9p-52; 0x47305b4adb501p-51; 0x1098e31eaf7b67p-54]);
  (3%nat, -0x1p531, [1; 0; 0; 0]);
  (5%nat, 0x3ffffffffffffp481, [0x13991c2c187f63p-198; 0x7596a90892fbfp-145; 0x45d1745d17453p-96; 0x7ffffffffffddp-51])]);
(3%nat, [0x1p40; 0x1p40; 0x1p40; 0x1p40; 0x40000000002dp-6; 0x400000000035p-6; 0x10000000001p0; 0x10000000001p0; 0x10000000001p0; 0x10000000001p0],
 [(3%nat, 0x1p40, [1; 0; 0; 0]);
  (5%nat, 0x10000000001p0, [0; 0; 0; 1]);
  (5%nat, 0x400000000035p-6, [0x65e50d79435e5p-54; 0xb9242a8c68f3fp-52; 0x16b1490aa31a3dp-55; 0]);
  (5%nat, 0x10000000000dfp-8, [0x157e50d79435e5p-57; 0x8ca1fe94eb6f5p-52; 0xc93db1fe94eb7p-53; 0x1p-6]);
  (3%nat, 0x800000000045bp-11, [0x178b6f51d25933p-59; 0xc2bd9c1c0e473p-54; 0x215b0e5b927adp-50; 0x46f2f1a07837dp-52]);
  (3%nat, 0xffffffffffp0, [1; 0; 0; 0])]);
(3%nat, [0; 0; 0; 0; 0x1p-56; 0x1dp-6; 0x27p-6; 0x3fffffffp-30; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 1]);
  (5%nat, 0x1dp-6, [0x10d4be86fc20fdp-56; 0x131d33abad268bp-53; 0x15906906e6aaabp-54; 0]);
  (5%nat, 0x49p-7, [0x10d4be86fc20fdp-62; 0x17997be5eacec1p-54; 0x9885c2a770821p-52; 0x11a1f58d90a4cbp-57]);
  (4%nat, 0x374684fd98f69p-52, [0x125cc3ca70c23dp-55; 0xfb084c0af2a47p-53; 0xa8da38665ecbdp-53; 0x12aa6c64eb86cbp-57]);
  (3%nat, -1, [1; 0; 0; 0]);
  (7%nat, 0x7ffffffffffffp-51, [0x95cbec1aeaa47p-172; 0x7ae1466666665p-120; 0x2ffffe800003fp-69; 0x3ffffa00003p-42])]);
(3%nat, [-1; -1; -1; -1; -0; 0; 0x17p-6; 0xdp-4; 1; 1; 1; 1],
 [(3%nat, -1, [1; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 1]);
  (6%nat, 0x17p-6, [0x9f3e1b442a6a1p-53; 0x87afb74a398ffp-52; 0xa2c4ec4ec4ec5p-54; 0]);
  (6%nat, 0x79p-8, [0x10cb8ce030792fp-55; 0x85665346d367fp-52; 0x570244ffcd049p-52; 0x4009bf1fd423fp-57]);
  (3%nat, -0xcb48df2351d13p-52, [0x1005e36c7c4e53p-53; 0xc771436a6e067p-53; 0xd39a7ad3028d3p-55; 0x1a4f38c8638879p-60]);
  (3%nat, -3, [1; 0; 0; 0]);
  (7%nat, 0x1ffffffffffffbp-53, [0x8214d0214d021p-200; 0x13831f3831f37bp-149; 0x9fffffffffff5p-98; 0x1fffffffffffafp-53])]);
(3%nat, [0; 0; 0; 0; 0x1p-5; 0x16edf444fde17fp-54; 0x93d60f15be7fbp-52; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (6%nat, 1, [0; 0; 0; 1]);
  (5%nat, 0x16edf444fde17fp-54, [0x9bfe4e8ee597fp-54; 0x52a1ca6a9285fp-51; 0x19de6bc390c70dp-55; 0]);
  (5%nat, 0x3861942a5111dp-51, [0x4c2b2c5bc61b3p-55; 0x1285fcea2c6fcdp-53; 0xc16ed9e856f95p-53; 0x193462ef841971p-60]);
  (5%nat, 0xe0895942f4cc9p-53, [0x4f6edf9e41283p-55; 0x94fe7b6ca666dp-52; 0x17e7081f7105edp-54; 0x1778821cd5c7abp-60]);
  (3%nat, -1, [1; 0; 0; 0]);
  (6%nat, 0x1ffffffffffffbp-53, [0xedf1e07142425p-202; 0x1149c61b6dd067p-150; 0x11c037ba6063f9p-100; 0x1fffffffffffddp-53])]);
(3%nat, [0; 0; 0; 0; 0x7p-6; 0x9p-6; 0x7p-5; 0x1a4013d16919c3p-54; 0x1a4013d16919c3p-54; 0x1bp-6; 0x1d4c3db14f3927p-53; 0xfcf67d06b6dcdp-52; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (11%nat, 1, [0; 0; 0; 1]);
  (9%nat, 0x1bp-6, [0x1e88a75d8caa15p-53; 0x5cdfdf25e993fp-55; 0xf64976ebe655p-59; 0]);
  (9%nat, 0x9b64b913edab7p-52, [0xee8b9b8adaf0fp-54; 0xf37ee5270becdp-53; 0x81216c8d24e17p-53; 0x1419e08661b941p-57]);
  (9%nat, 0x22a597221af59p-50, [0x6a6012d4482d5p-52; 0x1c815bda5f52fp-50; 0x107368e75f63d5p-55; 0xaceafcdeefce1p-58]);
  (3%nat, -1, [1; 0; 0; 0]);
  (11%nat, 0x1ffffffffffffbp-53, [0xd2c396a282ab5p-193; 0x491bd8405eeb9p-140; 0x9e0aeb6d47065p-94; 0x1ffffffffffb0fp-53])]);
(3%nat, [0; 0; 0; 0; 0x18cbccfa5bbc19p-57; 0x926c0bed9bd97p-52; 0x161e9358e2c9a1p-53; 0x161e9358e2c9a1p-53; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 1]);
  (7%nat, 0x161e9358e2c9a1p-53, [0xb8aaabd1c37f5p-52; 0x11d5550b8f202bp-54; 0; 0]);
  (3%nat, 0x18cbccfa5bbc19p-58, [0x1p-3; 0x1a55d063b3b6ddp-53; 0xd20e393bab5e5p-56; 0x184ca753c99911p-63]);
  (4%nat, 0x117869f5d7ee09p-53, [0xd784d44e6eb1p-61; 0x1d5253a07848fdp-57; 0x5f934a02ddb9fp-52; 0x12379a00c875c3p-53]);
  (3%nat, -1, [1; 0; 0; 0]);
  (7%nat, 0x3ffffffffffffp-50, [0x18814273cee315p-198; 0xfbbcc52246689p-147; 0x9b74eaf6fa26fp-98; 0x1fffffffffffb3p-53])]);
(3%nat, [0; 0; 0; 0; 0x1ffffffffffffdp-53; 0xfffffffffffffp-52; 0xfffffffffffffp-52; 0x1fffffffffffffp-53; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 1]);
  (4%nat, 0x1ffffffffffffdp-53, [0x8000000000001p-157; 0x1p-52; 0x1fffffffffffffp-53; 0]);
  (3%nat, 0x1ffffffffffffdp-54, [0x1p-3; 0x3p-3; 0x3p-3; 0x1fffffffffffffp-56]);
  (3%nat, 0xc398a6437047p-50, [0x10f1446b3dc847p-53; 0x6001f81c29843p-52; 0x5aaca41d37eebp-54; 0x1c8bb829a3dedfp-60]);
  (3%nat, -1, [1; 0; 0; 0]);
  (3%nat, 0x3ffffffffffffp-50, [0x1f400000000009p-205; 0x16bfffffffffffp-152; 0x43fffffffffffp-99; 0x1ffffffffffffp-49])]);
(3%nat, [-0x7p-1; -3; -0x9p-2; -0x3p-1; 0x3p-2; 1; 0x3p-1; 0x9p-2; 3; 0x7p-1; 0x7p-1],
 [(3%nat, -0x3p-1, [0x1ccccccccccccdp-54; 0xfc0fc0fc0fc1p-49; 0xec4ec4ec4ec4fp-56; 0]);
  (6%nat, 0x9p-2, [0; 0x3p-4; 0x5p-3; 0x3p-4]);
  (5%nat, 1, [0x71c71c71c71c7p-54; 0x1aaaaaaaaaaaabp-53; 0x71c71c71c71c7p-55; 0]);
  (5%nat, 0x15p-4, [0x3p-9; 0x11dp-9; 0x1a7p-10; 0x19p-10]);
  (3%nat, -0x15e19c55cc1f5p-52, [0x17978886acbea1p-58; 0x85a45a510aacdp-53; 0x118b043a24cc39p-53; 0x1577e772548c15p-55]);
  (3%nat, -0x15p-2, [0x1ccccccccccccdp-54; 0xfc0fc0fc0fc1p-49; 0xec4ec4ec4ec4fp-56; 0]);
  (6%nat, 0x8ffffffffffffp-50, [0x16c16c16c16c17p-203; 0x18000000000019p-55; 0x5p-3; 0x2fffffffffffdp-52])]);
(3%nat, [0; 0; 0; 0; 0x9f8a1af885c3fp474; 0x9f8a1af885c3fp474; 0x1e7d6b66d32f19p476; 0xbp526; 0x1p531; 0x1p531; 0x1p531; 0x1p531],
 [(3%nat, 0, [1; 0; 0; 0]);
  (7%nat, 0x1p531, [0; 0; 0; 1]);
  (7%nat, 0xbp526, [0x1273229c60ecedp-53; 0x19df37cb111f3p-50; 0x13a82fc2d06f33p-58; 0]);
  (5%nat, 0xcfde189fc8013p476, [0x1cb1eefc1cc95fp-55; 0x4681591541387p-51; 0x37916e5833883p-52; 0x820061441d0bp-54]);
  (7%nat, 0x4876aeaf276adp480, [0x554fa58316b65p-53; 0xffcd9795a5679p-53; 0x12dee3117be81fp-54; 0x4faea96d92845p-55]);
  (3%nat, -0x1p531, [1; 0; 0; 0]);
  (7%nat, 0x3ffffffffffffp481, [0x4147c4e7a8d3dp-199; 0x1800dd76493e49p-150; 0x12492492492485p-100; 0xfffffffffffedp-52])])].

Definition rows_5 : list (nat * list float * list (nat * float * list float)) := [
(3%nat, [-0x1dcd65p9; -0x1dcd65p9; -0x1dcd65p9; -0x1dcd65p9; -0x3b9ac9fffb03bp-20; -0x3b9ac9fffb03bp-20; -0x1dcd64ffe18295p-23; -0x773593ff5p-5; -0x3b9ac9ffp0; -0x3b9ac9ffp0; -0x3b9ac9ffp0; -0x3b9ac9ffp0],
 [(3%nat, -0x1dcd65p9, [1; 0; 0; 0]);
  (7%nat, -0x3b9ac9ffp0, [0; 0; 0; 1]);
  (5%nat, -0x3b9ac9fffb03bp-20, [0x1d623cceeb173fp-53; 0x14ee1988a74607p-56; 0; 0]);
  (3%nat, -0xee6b27fff10b1p-22, [0x1p-6; 0x9p-6; 0xcf2b8d3a596e7p-52; 0x8d472c5a6918bp-56]);
  (7%nat, -0xee6b27fd6769dp-22, [0x1694e4f7e7678fp-56; 0xcfbb0955cc2dbp-53; 0x67c98b60509bfp-52; 0x19c40afce1e5a1p-56]);
  (3%nat, -0x3b9aca01p0, [1; 0; 0; 0])]);
(3%nat, [0; 0; 0; 0; 0x1p-159; 0xdp-5; 0x35p-6; 0xfffffffffffp-44; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 1]);
  (5%nat, 0xdp-5, [0x84e03193e9c35p-53; 0x11516255d98a09p-53; 0x19826a439f6707p-55; 0]);
  (7%nat, 0x7ffffffffffbp-47, [0x991c2c187f633p-138; 0x565d1745d169bp-92; 0x1e4ffffffff533p-53; 0x1bp-9]);
  (4%nat, 0x1b1a51254348bp-53, [0x150cd79bada3cbp-53; 0xa33b6af1b9389p-53; 0xbbd5110cfeb01p-57; 0x739485393f8f5p-62]);
  (3%nat, -1, [1; 0; 0; 0])]);
(3%nat, [-1; -1; -1; -1; -0; 0; 0x11p-5; 0x27p-6; 1; 1; 1; 1],
 [(3%nat, -1, [1; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 1]);
  (6%nat, 0x11p-5, [0x10d4be86fc20fdp-58; 0x10a74ceaf611d7p-53; 0xed20d20d20d21p-53; 0]);
  (3%nat, -0x1p-3, [0x1p-9; 0x15p-9; 0x85p-8; 0x7p-4]);
  (6%nat, 0x4479c3d2f6ba7p-51, [0x1d156432554e47p-59; 0x1069765cfff83dp-53; 0x1e445b9ae070ebp-54; 0x191319e84f9d6bp-71]);
  (3%nat, -3, [1; 0; 0; 0]);
  (7%nat, 0x1ffffffffffffp-49, [0x15d867c3ece2a5p-197; 0x4189374bc6a7bp-144; 0x1eb851eb851e7p-95; 0xfffffffffffc3p-52])]);
(1%nat, [0; 0; 0x18c830273eadb3p-55; 0x1a140c57ac1d73p-54; 0x122114c22d4039p-53; 0x628c07c630bc7p-51; 0xdp-4; 0x7p-3; 1; 1],
 [(1%nat, 0, [1; 0]);
  (7%nat, 1, [0; 1]);
  (5%nat, 0x628c07c630bc7p-51, [1; 0]);
  (3%nat, 0x10386f49cc8da9p-53, [0x18000000000003p-54; 0x13ffffffffffffp-53]);
  (3%nat, 0xe2cc631886aa9p-53, [0x31b840392243fp-50; 0xe47bfc6ddbc1p-50]);
  (1%nat, -1, [1; 0]);
  (7%nat, 0x1ffffffffffffbp-53, [0x5p-50; 0x3fffffffffffbp-50])]);
(1%nat, [0; 0; 0xaad8965941889p-52; 0x1da52142db9473p-53; 1; 1],
 [(1%nat, 0, [1; 0]);
  (3%nat, 1, [0; 1]);
  (3%nat, 0x1da52142db9473p-53, [1; 0]);
  (1%nat, 0x802270c2f1267p-52, [0x1ffffffffffffdp-55; 0x3p-2]);
  (1%nat, 0xf18a870c6f537p-53, [0x96119798e6f57p-53; 0x2d3dcd0ce3215p-50]);
  (1%nat, -1, [1; 0]);
  (3%nat, 0x3ffffffffffffp-50, [0x1b2d3a21bc680bp-99; 0x1fffffffffff93p-53])]);
(1%nat, [0; 0; 0x1p-3; 0xe9973dd3a092fp-54; 1; 1],
 [(1%nat, 0, [1; 0]);
  (3%nat, 1, [0; 1]);
  (2%nat, 0x1p-3, [1; 0]);
  (3%nat, 0x847fa1a91116fp-52, [0x14000000000001p-53; 0xbffffffffffffp-53]);
  (3%nat, 0x12d78307574931p-53, [0x110bfb7ddf2e6bp-53; 0xef4048220d195p-53]);
  (1%nat, -1, [1; 0]);
  (3%nat, 0xffffffffffffdp-52, [0x7c5efb2a43fd1p-101; 0x3ffffffffffffp-50])]);
(1%nat, [0; 0; 0xbffe6d9edaf19p-52; 0x17ffcdb3db5e33p-53; 0x17ffcdb3db5e33p-53; 1; 1],
 [(1%nat, 0, [1; 0]);
  (4%nat, 1, [0; 1]);
  (4%nat, 0x17ffcdb3db5e33p-53, [1; 0]);
  (2%nat, 0xbffe6d9edaf19p-52, [1; 0]);
  (1%nat, 0xb15ce6146bba7p-53, [0x1138232f063267p-53; 0x1d8fb9a1f39b31p-54]);
  (1%nat, -1, [1; 0]);
  (4%nat, 0xfffffffffffffp-52, [0xfff9b6a2f221bp-102; 0x3ffffffffffffp-50])]);
(1%nat, [-1; 0x1p-2; 1; 0x9p-2; 3; 0x7p-1],
 [(1%nat, 0x1p-2, [1; 0]);
  (3%nat, 3, [0; 1]);
  (2%nat, 1, [1; 0]);
  (1%nat, 0x1dp-5, [0x1p-3; 0x7p-3]);
  (2%nat, 0x10634efdc29b43p-52, [0x1f611b36c8a12fp-53; 0x4f72649baf68dp-56]);
  (1%nat, -0x5p-1, [1; 0]);
  (3%nat, 0xbfffffffffffdp-50, [0x1p-48; 0xffffffffffffp-48])]);
(1%nat, [0; 0; 0x2bp-537; 0x3dp-537; 0x1p-531; 0x1p-531],
 [(1%nat, 0, [1; 0]);
  (3%nat, 0x1p-531, [0; 1]);
  (3%nat, 0x3dp-537, [1; 0]);
  (3%nat, 0x7dp-538, [0x1p-1; 0x1p-1]);
  (1%nat, 0x138dc1345be955p-584, [0x172c985afb19dp-52; 0xe8d367a504e63p-52]);
  (1%nat, -0x1p-531, [1; 0])]);
(1%nat, [-0x1dcd65p9; -0x1dcd65p9; -0xee6b27fd5p-6; -0xee6b27fc3p-6; -0x3b9ac9ffp0; -0x3b9ac9ffp0],
 [(1%nat, -0x1dcd65p9, [1; 0]);
  (3%nat, -0x3b9ac9ffp0, [0; 1]);
  (2%nat, -0xee6b27fd5p-6, [1; 0]);
  (3%nat, -0x773593fe0fp-9, [0x5p-3; 0x3p-3]);
  (1%nat, -0x1dcd64ffdaba69p-23, [0x1221a417d05f41p-53; 0x1bbcb7d05f417dp-54]);
  (1%nat, -0x3b9aca01p0, [1; 0])]);
(1%nat, [0; 0; 0x1p-50; 0x1p-3; 0x29p-6; 0x1fffffp-21; 1; 1],
 [(1%nat, 0, [1; 0]);
  (5%nat, 1, [0; 1]);
  (4%nat, 0x29p-6, [1; 0]);
  (4%nat, 0x347fffp-22, [0x1p-1; 0x1p-1]);
  (3%nat, 0x38017abfc76d3p-51, [0xc9a6f26e52065p-53; 0x136590d91adf9bp-53]);
  (1%nat, -1, [1; 0]);
  (5%nat, 0x1ffffffffffffdp-53, [0x3p-32; 0xfffffffdp-32])]);
(1%nat, [-1; -1; -0; 0; 0x156a2f1451977bp-56; 0x9p-4; 1; 1],
 [(1%nat, -1, [1; 0]);
  (5%nat, 1, [0; 1]);
  (3%nat, -0, [1; 0]);
  (4%nat, 0x92f3a4c71d923p-54, [0x7p-3; 0x1p-3]);
  (3%nat, 0x5826a02ad319p-52, [0xbe2366ece81f3p-52; 0x10772644c5f833p-54]);
  (1%nat, -3, [1; 0]);
  (5%nat, 0x1ffffffffffff9p-53, [0x1p-49; 0x1ffffffffffffp-49])]);
(5%nat, [0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (5%nat, 1, [0; 0; 0; 0; 0; 1]);
  (5%nat, 0x3p-3, [0xc35p-15; 0x249fp-15; 0x15f9p-14; 0xd2fp-14; 0x7e9p-15; 0xf3p-15]);
  (5%nat, 0x2581f1869d1bfp-52, [0x1cfbf71ad903a3p-54; 0x18e0c1e246a6bp-50; 0x88a9741d7e7e7p-54; 0xbbae576707fe1p-57; 0x101bf2a00c3cffp-61; 0x46cb3e9154127p-64]);
  (5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (5%nat, 0x3ffffffffffffp-50, [0x1p-250; 0x13fffffffffffbp-250; 0x9fffffffffffbp-198; 0x13fffffffffff1p-149; 0x4fffffffffffbp-98; 0x3fffffffffffbp-50]);
  (5%nat, 0x1p-2, [0xf3p-10; 0x195p-10; 0x87p-9; 0x2dp-9; 0xfp-10; 0x1p-10]);
  (5%nat, -0x1p-1074, [1; 0; 0; 0; 0; 0]);
  (5%nat, 0x297a21c3b2a71p-52, [0xd38ffeeb63edbp-53; 0x1990c016f874b3p-54; 0x9e2cc5a86f455p-54; 0xf4a8d109ddfe1p-57; 0x17a6e452096f4dp-61; 0xea232e2534117p-65]);
  (5%nat, 0xe6dd7e8ab669p-49, [0x66395b7a31cb9p-55; 0x347744592f7d9p-52; 0x2b15a0ed18b63p-51; 0x11b0b688b83e89p-54; 0x3a1bbe7f89553p-53; 0x131653eaccdf83p-58]);
  (5%nat, 0x10000000000001p-52, [0; 0; 0; 0; 0; 1]);
  (5%nat, 2, [0; 0; 0; 0; 0; 1])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x1a39e7a6cea223p-56; 0x9a91b1b7486cdp-54; 0x2024aae50196fp-51; 0x5a53b53750d9p-47; 0xd029aa9b8c171p-52; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (10%nat, 1, [0; 0; 0; 0; 0; 1]);
  (6%nat, 0x1a39e7a6cea223p-56, [0xaea02eb072c9p-54; 0x90031644092e9p-53; 0x98c7e78f46381p-52; 0xd9814f955d673p-55; 0x14be2a147b8a23p-60; 0]);
  (5%nat, 0x1a39e7a6cea223p-57, [0x1fffffffffffffp-58; 0x12d80f30d97a15p-54; 0x1ee79957b2fac7p-54; 0xba078f0c3b833p-54; 0x9d46c16d437c5p-58; 0x14be2a147b8a21p-65]);
  (8%nat, 0x1046e2a4b8d37fp-53, [0x100e0dad03ac4bp-60; 0x55966190b6157p-54; 0x64d34ab48db6dp-52; 0xc0ecf74a29c2dp-53; 0x866f37343ef73p-54; 0x159f94d27f4e13p-59]);
  (5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (10%nat, 0x3ffffffffffffp-50, [0x1fdc250436a72bp-298; 0x477d7306d83d9p-243; 0xf2cba53a30915p-194; 0x2d74cb9f1450fp-142; 0x1ac1e4b8c81883p-98; 0x1fffffffffff29p-53])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x2ef8a497db77p-49; 0x1p-2; 0x14f6506ce63a87p-54; 0x3p-2; 0x3p-2; 0x3p-2; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (11%nat, 1, [0; 0; 0; 0; 0; 1]);
  (7%nat, 0x1p-2, [0x23bb590c04405p-57; 0xc89a8f1152489p-53; 0x1c23355d5164fp-50; 0x13d2614f9a7b3bp-55; 0x131a2cd3e17c5dp-59; 0]);
  (6%nat, 0xaef8a497db77p-50, [0x148e30266ee547p-60; 0x10173b6c9cd755p-55; 0x262b02ea8cd7dp-50; 0x7b2528e29b3e1p-53; 0x106dd7b8150681p-57; 0x131a2cd3e17c5dp-64]);
  (8%nat, 0x812e8642ef8bdp-52, [0x174bbbfc88988bp-59; 0xce938a104c57fp-55; 0x54f8446a071f5p-52; 0xe7e4d3409c879p-53; 0xc855c9ca545b5p-55; 0x14eaffac57373p-56]);
  (5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (11%nat, 0x1ffffffffffff9p-53, [0x1045835a601c3bp-296; 0x116f0cbc426759p-244; 0x3597ffffffffbp-191; 0x1e9fffffffffbp-142; 0x45ffffffffff1p-96; 0x7ffffffffffddp-51])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x1ffffffffffffdp-53; 0x1ffffffffffffdp-53; 0xfffffffffffffp-52; 0x1fffffffffffffp-53; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (9%nat, 1, [0; 0; 0; 0; 0; 1]);
  (9%nat, 0x1fffffffffffffp-53, [0x71c71c71c71c7p-108; 0xa12f684bda12fp-54; 0x3p-3; 0x19ed097b425edp-50; 0x1p-4; 0]);
  (5%nat, 0x1ffffffffffffdp-54, [0x1p-5; 0x5p-5; 0x5p-4; 0x5p-4; 0x5p-5; 0x7ffffffffffffp-56]);
  (5%nat, 0x475b92c9f15fdp-53, [0x1e37b9960f9c9dp-54; 0xc3bcffcedf51p-49; 0x1fb2a988cd6069p-56; 0xa442e2ab988bp-53; 0xd4cdd61810a41p-61; 0x1b91b8ddbff6ffp-67]);
  (5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (5%nat, 0x3ffffffffffffp-50, [0x61a8000000003p-304; 0xc350000000003p-252; 0x17d7ffffffffffp-201; 0xa5ffffffffffdp-149; 0x7bffffffffffbp-99; 0xffffffffffff1p-52])]);
(5%nat, [-0xdp-2; -2; -0x3p-1; -1; -0x1p-1; -0x1p-1; 0x1p-1; 0x7p-2; 2; 2; 0x5p-1; 0x7p-1; 0xfp-2; 0xfp-2; 0xfp-2],
 [(5%nat, -0x1p-1, [0x11111111111111p-55; 0x9e9cd28757011p-52; 0xf2ac4209f2137p-54; 0xa57eb50295fadp-58; 0; 0]);
  (7%nat, 2, [0; 0; 0x71c71c71c71c7p-56; 0x8820820820821p-52; 0x1bcf3cf3cf3cf5p-54; 0x30c30c30c30c3p-57]);
  (6%nat, 0x1p-1, [0x1ba06f0986933fp-57; 0x14c5f601400373p-54; 0x1b3b87a857c479p-54; 0x160c2fd655012fp-55; 0x308b91419ca25p-55; 0]);
  (5%nat, -0x3p-3, [0x8c0eeeeeeeeefp-55; 0x11f373eda11d4dp-53; 0x2b8d6e8b0394dp-51; 0x1f091bef25a83p-54; 0xaa500c8a74753p-65; 0x308b91419ca25p-70]);
  (6%nat, 0x15899b1063e73p-49, [0x1a3ac633327dbbp-58; 0xe7f29ad743b75p-54; 0xdbb10e57220c5p-53; 0x1108dfcc87b803p-54; 0x1af00e311e08e5p-57; 0x1348e471034663p-69]);
  (5%nat, -3, [0x11111111111111p-55; 0x9e9cd28757011p-52; 0xf2ac4209f2137p-54; 0xa57eb50295fadp-58; 0; 0]);
  (7%nat, 0xffffffffffffbp-51, [0x1bc71c71c71c73p-299; 0x14d55555555547p-246; 0x1c71c71c71c7dp-54; 0x882082082082bp-52; 0x6f3cf3cf3cf31p-52; 0x30c30c30c309dp-57])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x52d0c388d7655p-584; 0x1p-531; 0x1p-531; 0x1p-531; 0x1p-531; 0x1p-531; 0x1p-531],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (6%nat, 0x1p-531, [0; 0; 0; 0; 0; 1]);
  (6%nat, 0x52d0c388d7655p-584, [0x7e6598f90e87p-48; 0x1863b998e52f1p-50; 0xe1e5e866d681bp-55; 0xe879f168d1045p-58; 0x166de86f543783p-63; 0]);
  (5%nat, 0x90ed562f78f15p-585, [0xffffffffffffp-63; 0x11cc4c4775806dp-53; 0xb3ce65f560493p-53; 0xaad6c5b641e75p-55; 0x4851fd8000e31p-57; 0xb81136dca0413p-63]);
  (6%nat, 0xd7ebf3602b6fdp-583, [0x1d69476c8aca7dp-66; 0x1894b6e9ef2783p-61; 0x83037058b6b73p-56; 0x15aaa4d48d10dp-51; 0x384fc3bff8b5dp-51; 0xb61def907cd6bp-53]);
  (5%nat, -0x1p-531, [1; 0; 0; 0; 0; 0]);
  (6%nat, 0x3ffffffffffffp-581, [0x13165d5231e53fp-302; 0x2fb7e94d7cbd1p-247; 0xbedfa535f2f41p-198; 0x5f6fd29af979fp-147; 0x5f6fd29af979dp-98; 0xfffffffffffe7p-52])]);
(5%nat, [0x1p40; 0x1p40; 0x1p40; 0x1p40; 0x1p40; 0x1p40; 0x10000000000297p-12; 0x10000000001p0; 0x10000000001p0; 0x10000000001p0; 0x10000000001p0; 0x10000000001p0; 0x10000000001p0],
 [(5%nat, 0x1p40, [1; 0; 0; 0; 0; 0]);
  (6%nat, 0x10000000001p0, [0; 0; 0; 0; 0; 1]);
  (6%nat, 0x10000000000297p-12, [0xfca74e369641fp-53; 0x18659cf444deffp-54; 0xe228ff48162ffp-55; 0xe8f21364defffp-58; 0x167e6e85907fffp-63; 0]);
  (5%nat, 0x4000000000053p-10, [0x1fc26802ed1fdfp-58; 0x2fabde672956dp-50; 0x66e544da52791p-53; 0x168ba3ff918e93p-58; 0x48f655baa5d7p-56; 0x16a9fd716c8031p-68]);
  (6%nat, 0x200000000018fp-9, [0x14790d46ef5eedp-63; 0x1657de4d8da7efp-59; 0x26cde021a56fdp-53; 0x8554e3f233585p-53; 0x6f70255bf89e5p-52; 0x1bc5455aedb4fp-51]);
  (5%nat, 0xffffffffffp0, [1; 0; 0; 0; 0; 0])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x1p-54; 0x1p-1; 0x1cda07e1e63871p-53; 0x3fffffp-22; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (9%nat, 1, [0; 0; 0; 0; 0; 1]);
  (9%nat, 0x3fffffp-22, [0x28a8198f3f53p-129; 0x28a8174f61553p-109; 0x79f83bf40f89dp-88; 0xa2a037dfb75c9p-68; 0xffff5d5fc080dp-52; 0]);
  (9%nat, 0x1fffffbp-25, [0x1f04c0001a0003p-140; 0x36484e48d3725p-112; 0x12078e345e1af1p-91; 0x15ac95eef9a6e7p-70; 0xfe19a94da6033p-52; 0xf3p-15]);
  (6%nat, 0x2ea04a146213fp-53, [0x176b991b5129fbp-54; 0xfe52f26e750cfp-53; 0x1fa11f0fa875d5p-56; 0xd66b169b47909p-58; 0x58dbb423f9e0fp-61; 0x1d22eb2812efa1p-69]);
  (5%nat, -1, [1; 0; 0; 0; 0; 0])]);
(5%nat, [-1; -1; -1; -1; -1; -1; -0; 0; 0x5596c3ceda4a9p-56; 0x1bc446b15132fbp-56; 1; 1; 1; 1; 1; 1],
 [(5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (9%nat, 1, [0; 0; 0; 0; 0; 1]);
  (7%nat, -0, [0x47ee7145bb14dp-67; 0x6043758e4eea1p-57; 0x8be0c33e1533fp-52; 0xe23922712b927p-53; 0; -0]);
  (7%nat, 0x100c44b6c8edfbp-59, [0x36e11acb834b5p-70; 0x42b1097078a45p-57; 0x884deb6cd4bc1p-52; 0x1d66fffc040e89p-54; 0x1f99d52df26e37p-70; 0x6ff7b411b283p-73]);
  (9%nat, 0x1898fc6e2ee55p-50, [0x67c380d87f14bp-55; 0xb47657ceefb89p-53; 0x59fa750460bf7p-52; 0x190561e56b030fp-55; 0x6069f36d06959p-55; 0x173d9814151cfdp-61]);
  (5%nat, -3, [1; 0; 0; 0; 0; 0]);
  (9%nat, 0x3ffffffffffffp-50, [0x12545df0b6b91p-299; 0xb74bab67233a7p-249; 0x2dd2ead9c8ce9p-196; 0xb74bab67233a1p-148; 0x59bb951ffe3dfp-98; 0x7fffffffffff5p-51])]);
(3%nat, [0; 0; 0; 0; 0x37p-6; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (4%nat, 1, [0; 0; 0; 1]);
  (4%nat, 0x37p-6, [0x51p-12; 0x1efp-11; 0xbd1p-12; 0]);
  (3%nat, 0xa5p-8, [0x1p-6; 0xd54bp-18; 0xedd5p-17; 0x13f0bp-18]);
  (4%nat, 0x1cec2e99515c85p-53, [0xcf40155a5a017p-59; 0x8f072f1544711p-54; 0x1a5126153c6ff3p-53; 0x205a0d985ac07p-54]);
  (3%nat, -1, [1; 0; 0; 0]);
  (4%nat, 0x3ffffffffffffp-50, [0x71c71c71c71c7p-198; 0x15555555555545p-148; 0xaaaaaaaaaaa95p-97; 0x1fffffffffff55p-53])]);
(3%nat, [0; 0; 0; 0; 0x3p-6; 0x19p-6; 0x12107986ccb85fp-53; 0x12107986ccb85fp-53; 0x3fp-6; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (8%nat, 1, [0; 0; 0; 1]);
  (8%nat, 0x3fp-6, [0x1517671add7bd1p-62; 0x46d81d9389ab9p-54; 0x1dbeb35fd643e5p-53; 0]);
  (4%nat, 0x27p-7, [0x18c7e28240b781p-59; 0x9ca19c3749199p-53; 0x1fbd604651d1f1p-54; 0x17d05a3d660a45p-55]);
  (7%nat, 0xf42d7802789abp-52, [0x11dcf5505887b7p-64; 0x172639c9a3fe55p-58; 0x78e53e11983bp-49; 0x5ed8fac7bd453p-51]);
  (3%nat, -1, [1; 0; 0; 0]);
  (8%nat, 0x3ffffffffffffp-50, [0x1517671add7bd1p-194; 0xdc711f64b00c3p-143; 0xbffffffffff39p-94; 0xffffffffffdp-44])]);
(3%nat, [0; 0; 0; 0; 0x111774e27e39afp-53; 0x111774e27e39afp-53; 0x111774e27e39afp-53; 0x111774e27e39afp-53; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 1]);
  (7%nat, 0x111774e27e39afp-53, [1; 0; 0; 0]);
  (7%nat, 0xb575486c77207p-52, [0x3e7ffffffffffp-52; 0xe0fffffffffffp-53; 0x8700000000001p-53; 0x3600000000001p-54]);
  (7%nat, 0x53256f933431dp-51, [0x1b3bd12d532ab5p-54; 0xd75ea779eb0f5p-53; 0x8deebdea44611p-54; 0x1f2dc09965a9d7p-59]);
  (3%nat, -1, [1; 0; 0; 0]);
  (7%nat, 0x7ffffffffffffp-51, [0x9e39fb2d1c5a7p-201; 0x6e92cb2dc7187p-149; 0x19c1e0ec55810bp-101; 0xffffffffffff3p-52])]);
(3%nat, [0; 0; 0; 0; 0x1p-960; 0x10000000000001p-1012; 0x8000000000001p-1011; 0x10000000000003p-1012; 0x10000000000003p-1012; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (8%nat, 1, [0; 0; 0; 1]);
  (5%nat, 0x10000000000001p-1012, [0x7ffffffffffffp-104; 0xd555555555555p-52; 0x15555555555555p-55; 0]);
  (6%nat, 0x8000000000001p-1011, [0x15555555555555p-55; 0x9555555555555p-52; 0x1p-2; 0]);
  (8%nat, 0x7413244d39c9p-47, [0x1a7f98a3fb07c1p-63; 0x305c56117382dp-55; 0xeb5c4c61c21c7p-54; 0x17dd0c5e83224fp-53]);
  (3%nat, -1, [1; 0; 0; 0]);
  (8%nat, 0x3ffffffffffffp-50, [0x1p-150; 0xbfffffffffffdp-150; 0x5fffffffffffdp-99; 0x3fffffffffffdp-50])]);
(3%nat, [-3; -2; -0x3p-2; -0x1p-1; 0x1p-2; 0x3p-2; 0x5p-1; 0x7p-1; 0x7p-1; 0xfp-2],
 [(3%nat, -0x1p-1, [0x1p-2; 0xb555555555555p-52; 0x15555555555555p-57; 0]);
  (5%nat, 0x5p-1, [0; 0x1ca4b3055ee191p-56; 0xf75fdb8b793fp-49; 0x67ab5f34e47efp-52]);
  (4%nat, 0x1p-2, [0x11111111111111p-55; 0x16eeeeeeeeeefp-49; 0x4cccccccccccdp-53; 0]);
  (3%nat, -0x1p-3, [0x1p-5; 0x8aeeeeeeeeeefp-52; 0xd088888888889p-53; 0x4cccccccccccdp-56]);
  (4%nat, 0xc08af159ec423p-53, [0x7239cf2eb60afp-55; 0xb521414a9961fp-52; 0xf1ce72b3395fdp-54; 0x47d04583096ddp-61]);
  (3%nat, -0x7p-1, [0x1p-2; 0xb555555555555p-52; 0x15555555555555p-57; 0]);
  (5%nat, 0x9fffffffffffdp-50, [0x9249249249249p-200; 0x1ca4b3055ee1dp-52; 0x1eebfb716f27fp-50; 0x67ab5f34e47e7p-52])]);
(3%nat, [0; 0; 0; 0; 0xb86a6b8aa48fdp479; 0x1p531; 0x1p531; 0x1p531; 0x1p531],
 [(3%nat, 0, [1; 0; 0; 0]);
  (4%nat, 0x1p531, [0; 0; 0; 1]);
  (4%nat, 0xb86a6b8aa48fdp479, [0xa0227df9fb649p-55; 0xce4512d8700e7p-53; 0x84d926d4888c3p-52; 0]);
  (4%nat, 0x1b86a6b8aa48fdp478, [0xa0227df9fb649p-58; 0x4f78d1b31295fp-53; 0xb5c30d2e8ec77p-52; 0x1fffffffffffffp-56]);
  (3%nat, 0x2fc8dd8d76889p479, [0xd03898ca5a52bp-53; 0x78438f3359535p-52; 0x1d507d54a3865p-52; 0x49f4e25abfa0fp-57]);
  (3%nat, -0x1p531, [1; 0; 0; 0]);
  (4%nat, 0xfffffffffffffp479, [0x727041f9a733p-201; 0xaba862f67acc7p-152; 0xaba862f67acc5p-100; 0x1fffffffffffe9p-53])]);
(3%nat, [0x1p40; 0x1p40; 0x1p40; 0x1p40; 0x10000000000b87p-12; 0x10000000001p0; 0x10000000001p0; 0x10000000001p0; 0x10000000001p0],
 [(3%nat, 0x1p40, [1; 0; 0; 0]);
  (4%nat, 0x10000000001p0, [0; 0; 0; 1]);
  (4%nat, 0x10000000000b87p-12, [0x140131p-24; 0x338ecfp-23; 0x84e131p-24; 0]);
  (4%nat, 0x8000000000771p-11, [0x13f3c8ffc6c369p-62; 0x174fc4719aa1fp-53; 0x87f02746b3975p-52; 0x1b0609d71fff2dp-54]);
  (3%nat, 0x2000000000115p-9, [0x1fa4bb979555p-51; 0x4a6670ddfa7c5p-52; 0x1e5819e0513f55p-54; 0xe11240b7376fp-50]);
  (3%nat, 0xffffffffffp0, [1; 0; 0; 0])]);
(3%nat, [0; 0; 0; 0; 0x1p-46; 0xf2fb0ac1dc89dp-56; 0x5p-5; 0xfffffffffp-36; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 1]);
  (4%nat, 0x1p-46, [0x1fffffffffef23p-53; 0x10db78b538b5a9p-93; 0xd7c6090fa2d61p-137; 0]);
  (3%nat, 0x3p-49, [0x7dp-9; 0x182ffffffffce3p-53; 0xc72081dcadfbbp-95; 0x5b078bd298b25p-140]);
  (6%nat, 0x7cddd68f55f1fp-53, [0x8b6e27719cdadp-52; 0xc89b13448172bp-53; 0x3feb90a42026dp-54; 0x125ab0c6988603p-62]);
  (3%nat, -1, [1; 0; 0; 0]);
  (7%nat, 0x3ffffffffffffp-50, [0x28514feab119bp-163; 0x71c684bda12f5p-113; 0x17ffa0007ffff9p-65; 0x3ffd000bfffp-42])]);
(3%nat, [-1; -1; -1; -1; -0; 0; 0xdp-5; 0xdp-4; 1; 1; 1; 1],
 [(3%nat, -1, [1; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 1]);
  (7%nat, 0xdp-4, [0x1e50d79435e50dp-57; 0x1e3fd29d6deab9p-54; 0x77d849c02d629p-52; 0]);
  (3%nat, -0x3p-2, [0x1bp-6; 0x1bp-6; 0x1293e93e93e93fp-55; 0x16c16c16c16c17p-59]);
  (5%nat, 0x15693937e78f9p-51, [0xf0ddac831930bp-56; 0xbd3f032c7120fp-52; 0xc0476aee98169p-54; 0xe851d3edd198dp-58]);
  (3%nat, -3, [1; 0; 0; 0]);
  (7%nat, 0x1ffffffffffffp-49, [0x11f7047dc11f7p-192; 0x6bca1af286bc1p-144; 0x1fffffffffff9p-94; 0x1ffffffffffeffp-53])]);
(1%nat, [0; 0; 0xe5be89a80829bp-52; 1; 1],
 [(1%nat, 0, [1; 0]);
  (2%nat, 1, [0; 1]);
  (2%nat, 0xe5be89a80829bp-52, [1; 0]);
  (1%nat, 0x8f971609051a1p-52, [0x17ffffffffffffp-54; 0x5p-3]);
  (1%nat, 0xd8b2eb39d655fp-52, [0x1d128e7bab9ca7p-57; 0x1e2ed718454635p-53]);
  (1%nat, -1, [1; 0]);
  (2%nat, 0x3ffffffffffffp-50, [0x138021fc264a57p-99; 0x1fffffffffffb3p-53])]);
(1%nat, [0; 0; 0x11p-5; 1; 1],
 [(1%nat, 0, [1; 0]);
  (2%nat, 1, [0; 1]);
  (2%nat, 0x11p-5, [1; 0]);
  (1%nat, 0x33p-8, [0x5p-3; 0x3p-3]);
  (1%nat, 0xf154a5c860747p-53, [0xe6ec10b1de753p-55; 0x1c644fbd38862bp-53]);
  (1%nat, -1, [1; 0]);
  (2%nat, 0x3ffffffffffffp-50, [0x11111111111111p-101; 0x1fffffffffffefp-53])]);
(1%nat, [0; 0; 0x7690636685141p-51; 0x7690636685141p-51; 1; 1],
 [(1%nat, 0, [1; 0]);
  (3%nat, 1, [0; 1]);
  (3%nat, 0x7690636685141p-51, [1; 0]);
  (1%nat, 0x7690636685141p-52, [0x1p-1; 0x1p-1]);
  (1%nat, 0x6ba6c1c8c8cf5p-52, [0x8bc7f6c9c4227p-52; 0x1d0e024d8ef763p-54]);
  (1%nat, -1, [1; 0]);
  (3%nat, 0x3ffffffffffffp-50, [0x1b215400178475p-99; 0x1fffffffffff93p-53])]);
(1%nat, [0; 0; 0x1ffffffffffffdp-53; 0xfffffffffffffp-52; 0x1fffffffffffffp-53; 1; 1],
 [(1%nat, 0, [1; 0]);
  (4%nat, 1, [0; 1]);
  (3%nat, 0xfffffffffffffp-52, [1; 0]);
  (1%nat, 0x1ffffffffffffdp-56, [0x7p-3; 0x1p-3]);
  (1%nat, 0x6aed8d430319p-49, [0x1951272bcfce7p-49; 0x1abb6350c0c643p-55]);
  (1%nat, -1, [1; 0]);
  (1%nat, 0x3ffffffffffffp-50, [0xa000000000001p-102; 0x7ffffffffffffp-51])]);
(1%nat, [-2; -0x1p-1; 0x1p-1; 0x3p-1; 0x7p-2; 2; 0xdp-2; 0xdp-2],
 [(1%nat, -0x1p-1, [1; 0]);
  (5%nat, 0xdp-2, [0; 1]);
  (5%nat, 2, [1; 0]);
  (4%nat, 0x39p-5, [0x7p-3; 0x1p-3]);
  (5%nat, 0x1912cab3e1f8ffp-51, [0x17b8879c9a4ce7p-56; 0x7423bc31b2d99p-51]);
  (1%nat, -0x11p-2, [1; 0]);
  (5%nat, 0x19fffffffffffdp-51, [0x4cccccccccccdp-100; 0x1ffffffffffff7p-53])]);
(1%nat, [0; 0; 0x151f4dc6840489p-585; 0x29p-537; 0xd2451a2d113c1p-583; 0x1p-531; 0x1p-531],
 [(1%nat, 0, [1; 0]);
  (4%nat, 0x1p-531, [0; 1]);
  (3%nat, 0x29p-537, [1; 0]);
  (3%nat, 0x15391468b444fp-580, [0x1c000000000001p-53; 0x1ffffffffffff5p-56]);
  (1%nat, 0x4d1fea98a7325p-584, [0x8b28347ad68c9p-52; 0xe9af970a52e6dp-53]);
  (1%nat, -0x1p-531, [1; 0]);
  (4%nat, 0x1ffffffffffffdp-584, [0x432d4329e1e29p-99; 0x1fffffffffffefp-53])]);
(1%nat, [-0x1dcd65p9; -0x1dcd65p9; -0x773593ff57059p-21; -0xee6b27fd7p-6; -0x1dcd64ff96dd73p-23; -0x3b9ac9ffp0; -0x3b9ac9ffp0],
 [(1%nat, -0x1dcd65p9, [1; 0]);
  (4%nat, -0x3b9ac9ffp0, [0; 1]);
  (3%nat, -0xee6b27fd7p-6, [1; 0]);
  (2%nat, -0xee6b27fe0f059p-22, [0x1p-1; 0x1p-1]);
  (2%nat, -0x773593fee903dp-21, [0x9dd0037d767a9p-53; 0x1622ffc8289857p-53]);
  (1%nat, -0x3b9aca01p0, [1; 0])]);
(1%nat, [0; 0; 0x1p-152; 0x1p-1; 0x3dp-6; 0x3ffffffp-26; 1; 1],
 [(1%nat, 0, [1; 0]);
  (5%nat, 1, [0; 1]);
  (2%nat, 0x1p-152, [1; 0]);
  (5%nat, 0xffffffdp-28, [0x3p-2; 0x1p-2]);
  (3%nat, 0x1b507f1e7e7b9fp-53, [0x1c1eed4b16384fp-55; 0x63e112b4e9c7bp-51]);
  (1%nat, -1, [1; 0])]);
(1%nat, [-1; -1; -0; 0; 0x9p-6; 0x5p-5; 1; 1],
 [(1%nat, -1, [1; 0]);
  (5%nat, 1, [0; 1]);
  (4%nat, 0x9p-6, [1; 0]);
  (1%nat, -0x7p-3, [0x7p-3; 0x1p-3]);
  (1%nat, -0x1a781613802bdp-50, [0x1a781613802bdp-50; 0x2587e9ec7fd43p-50]);
  (1%nat, -3, [1; 0]);
  (5%nat, 0x1ffffffffffffp-49, [0x25ed097b425edp-98; 0x1fffffffffffedp-53])]);
(3%nat, [0; 0; 0; 0; 0x7p-6; 0x1bp-6; 0x31p-6; 0x37p-6; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 1]);
  (6%nat, 0x31p-6, [0x1b6db6db6db6dbp-58; 0x818b5de64d18bp-52; 0x77993462d7799p-52; 0]);
  (3%nat, 0x15p-9, [0x7dp-9; 0x153d097b425edp-49; 0xb8bda12f684bdp-55; 0x1p-9]);
  (4%nat, 0x1f9c63367fcedp-52, [0x1e92aa8b06fed9p-54; 0xf031d09a69787p-53; 0xd9b3b6d5de9b3p-56; 0x990ca8af5bc47p-67]);
  (3%nat, -1, [1; 0; 0; 0]);
  (7%nat, 0x3ffffffffffffp-50, [0x1a3d9aa001a3d9p-197; 0xb60b60b60b5ffp-145; 0x15555555555519p-98; 0x1fffffffffff55p-53])])].

Definition rows_6 : list (nat * list float * list (nat * float * list float)) := [
(3%nat, [0; 0; 0; 0; 0x5p-6; 0x5p-6; 0x5p-6; 0x73fca09714acdp-53; 0x73fca09714acdp-53; 0x116f99ff11c0ffp-53; 0x116f99ff11c0ffp-53; 0x116f99ff11c0ffp-53; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (11%nat, 1, [0; 0; 0; 1]);
  (11%nat, 0x116f99ff11c0ffp-53, [1; 0; 0; 0]);
  (11%nat, 0x1513b37f4d50bfp-53, [0xd800000000001p-53; 0x1bp-6; 0x8ffffffffffffp-54; 0xffffffffffffdp-58]);
  (11%nat, 0x16e38601baa6c3p-53, [0xfab7b5b8458a5p-54; 0x1c22476098219p-50; 0x21acb97ab60d1p-51; 0x1adf043443fa1p-53]);
  (3%nat, -1, [1; 0; 0; 0]);
  (11%nat, 0x7ffffffffffffp-51, [0xa9b74d8cd3c91p-201; 0xe7ba17576769dp-150; 0x697712472e367p-99; 0x1fffffffffffe5p-53])]);
(3%nat, [0; 0; 0; 0; 0x8e067406f0677p-53; 0x5p-3; 0x5p-3; 0x5p-3; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 1]);
  (7%nat, 0x5p-3, [1; 0; 0; 0]);
  (7%nat, 0x3dp-6, [0x1p-9; 0x15p-9; 0x93p-9; 0x157p-9]);
  (7%nat, 0x161bac19bef2ddp-53, [0x8f654b3681e13p-52; 0x16eb6c94bbcdf1p-54; 0x1389b346df358fp-56; 0x1634f2fafb1739p-60]);
  (3%nat, -1, [1; 0; 0; 0]);
  (7%nat, 0x1ffffffffffffdp-53, [0x1p-150; 0xbfffffffffffdp-150; 0x5fffffffffffdp-99; 0x1fffffffffffe9p-53])]);
(3%nat, [0; 0; 0; 0; 0x1p-960; 0x10000000000001p-1012; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (5%nat, 1, [0; 0; 0; 1]);
  (5%nat, 0x10000000000001p-1012, [1; 0x8000000000001p-1011; 0; 0]);
  (5%nat, 0x3p-2, [0x1p-6; 0x9p-6; 0x1bp-6; 0x1bp-6]);
  (5%nat, 0x4fb3f3c66163p-48, [0x14e700fd18ea27p-54; 0x1c597a9592ec2bp-54; 0x19a222118cbde7p-55; 0x1ee73648dcab9bp-58]);
  (3%nat, -1, [1; 0; 0; 0]);
  (5%nat, 0x3ffffffffffffp-50, [0x1p-150; 0xbfffffffffffdp-150; 0x5fffffffffffdp-99; 0x3fffffffffffdp-50])]);
(3%nat, [-4; -3; -0x9p-2; -0x7p-2; -0x5p-2; -0x3p-2; 0x7p-2; 0x7p-2; 2; 0x9p-2; 0xfp-2],
 [(3%nat, -0x7p-2, [0x9249249249249p-54; 0xb0c30c30c30c3p-52; 0x15555555555555p-55; 0]);
  (5%nat, 0x7p-2, [0; 0; 0xba2e8ba2e8ba3p-55; 0x3a2e8ba2e8ba3p-50]);
  (4%nat, -0x5p-2, [0x15555555555555p-55; 0x30c30c30c30c3p-50; 0x9249249249249p-55; 0]);
  (4%nat, -0x9p-3, [0x9p-7; 0x195e79e79e79e7p-53; 0x8bbefbefbefbfp-54; 0x71c71c71c71c7p-62]);
  (3%nat, -0x16f05c554953c1p-52, [0xe814d579b14c9p-59; 0xc9d6ef399a10dp-53; 0x12946373d9d897p-53; 0x12850c65c340ffp-58]);
  (3%nat, -0x15p-2, [0x9249249249249p-54; 0xb0c30c30c30c3p-52; 0x15555555555555p-55; 0]);
  (5%nat, 0x6fffffffffffdp-50, [0x10750750750751p-202; 0xe666666666663p-150; 0x2e8ba2e8ba303p-53; 0x1d1745d1745cfdp-53])]);
(3%nat, [0; 0; 0; 0; 0x1p529; 0x1p529; 0x1bp526; 0x1cdbc90f0ae9bp482; 0x1p531; 0x1p531; 0x1p531; 0x1p531],
 [(3%nat, 0, [1; 0; 0; 0]);
  (7%nat, 0x1p531, [0; 0; 0; 1]);
  (7%nat, 0x1cdbc90f0ae9bp482, [0x150dad1c621e9bp-56; 0x63c9ba2b81841p-51; 0x8d7b7a326b653p-54; 0]);
  (7%nat, 0xfcdbc90f0ae9bp479, [0x150dad1c621e9bp-65; 0x1bf28e03ebf4b1p-58; 0x9af1ab50eda39p-53; 0x157p-9]);
  (5%nat, 0x1ad562278714bfp478, [0x1fc3646515b6a7p-74; 0x5410e3b5bff9dp-57; 0x1264bf57e61683p-54; 0x16798e723c119bp-53]);
  (3%nat, -0x1p531, [1; 0; 0; 0]);
  (7%nat, 0x1fffffffffffffp478, [0x15bb18f23e5a83p-205; 0x18727c108625cfp-151; 0x3d1e36294f5e7p-98; 0x1fffffffffffe1p-53])]);
(3%nat, [0x1p40; 0x1p40; 0x1p40; 0x1p40; 0x40000000001p-2; 0x40000000001p-2; 0x20000000001bp-5; 0x8000000000737p-11; 0x10000000001p0; 0x10000000001p0; 0x10000000001p0; 0x10000000001p0],
 [(3%nat, 0x1p40, [1; 0; 0; 0]);
  (7%nat, 0x10000000001p0, [0; 0; 0; 1]);
  (6%nat, 0x20000000001bp-5, [0x41174f9e9dc09p-57; 0x8abab43035b79p-53; 0x17133d6d5e06c7p-53; 0]);
  (6%nat, 0x10000000000dd9p-12, [0x1ff1799fbd59cbp-62; 0x192f49bb326c97p-55; 0x1968f71c27a21p-49; 0x1d9edc1df20f5p-56]);
  (5%nat, 0x800000000045bp-11, [0xb8a11609314c7p-55; 0x1ccf0491583283p-54; 0x2f968c3a563edp-51; 0xb415942664765p-55]);
  (3%nat, 0xffffffffffp0, [1; 0; 0; 0])]);
(3%nat, [0; 0; 0; 0; 0x1p-143; 0x1314adf62e4c79p-53; 0xbp-4; 0x3fffffp-22; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 1]);
  (4%nat, 0x1p-143, [1; 0x1ad55230ba1049p-194; 0x9c1ef57897a49p-336; 0]);
  (7%nat, 0xfffffdp-24, [0xd601b851eea0dp-94; 0x40cccae250333p-70; 0x7dfff7e66688fp-51; 0x1p-6]);
  (6%nat, 0x1619bed1bc024dp-53, [0x1e096e30bbc525p-55; 0xb5755fb8a2e31p-52; 0x1cef65aaaada95p-57; 0x8884812afd19p-67]);
  (3%nat, -1, [1; 0; 0; 0])]);
(3%nat, [-1; -1; -1; -1; -0; 0; 0x13p-5; 0x374f54e117107p-50; 1; 1; 1; 1],
 [(3%nat, -1, [1; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 1]);
  (6%nat, 0x13p-5, [0xc897791c68007p-55; 0xfcfe147c1175fp-53; 0x1a1b81a79a913fp-54; 0]);
  (6%nat, 0x1a92b5227a1731p-53, [0xc897791c68007p-64; 0x1646a7ad229e63p-56; 0x9da8ab1442801p-52; 0x4c0423c7091b1p-52]);
  (7%nat, 0x3faed0ff6b79bp-50, [0x128044a24cb5adp-71; 0x157c82ef99cb37p-62; 0xd56fd6b2ea1f9p-55; 0xe4fbee1d5b105p-52]);
  (3%nat, -3, [1; 0; 0; 0]);
  (7%nat, 0x1ffffffffffffdp-53, [0x1e97804dfde09p-199; 0xf4bc026fef043p-149; 0x424840a8fb665p-97; 0x1fffffffffffbdp-53])]);
(2%nat, [0; 0; 0; 0x15f87f4fd1a1ebp-54; 1; 1; 1],
 [(2%nat, 0, [1; 0; 0]);
  (3%nat, 1, [0; 0; 1]);
  (3%nat, 0x15f87f4fd1a1ebp-54, [0xa81e02c0b9785p-52; 0x15f87f4fd1a1ebp-54; 0]);
  (2%nat, 0x99cb7b2ebb6d7p-53, [0x1ffffffffffff7p-59; 0x5c5b7d0dc7001p-51; 0x21a482f238fffp-51]);
  (3%nat, 0x598a5699179adp-51, [0x1198b7daf0a6f1p-55; 0x48bca388dbf17p-51; 0x12d5524e19b3d1p-54]);
  (2%nat, -1, [1; 0; 0]);
  (3%nat, 0x3ffffffffffffp-50, [0x185d2bea5658e3p-152; 0x185d2bea5658dbp-101; 0xffffffffffff3p-52])]);
(2%nat, [0; 0; 0; 0xfp-6; 0x25p-6; 0x2fp-6; 0x1f84a3d31e8af7p-53; 1; 1; 1],
 [(2%nat, 0, [1; 0; 0]);
  (6%nat, 1, [0; 0; 1]);
  (6%nat, 0x1f84a3d31e8af7p-53, [0x1d06a125fd6b87p-57; 0x1e2f95eda02947p-53; 0]);
  (5%nat, 0xe417331f98b6dp-52, [0xb1628eb5f153fp-55; 0x8b7ef9a2ad549p-52; 0x17952d21a5203dp-54]);
  (3%nat, 0xc966fb40f2839p-53, [0x15fcaf74fa90bp-51; 0x15cc0a9ab44d1dp-53; 0x4b4c9880d0eb7p-53]);
  (2%nat, -1, [1; 0; 0]);
  (6%nat, 0xfffffffffffffp-52, [0x3e803c83b75cdp-146; 0x84d08097e5a41p-96; 0xfffffffffff7bp-52])]);
(2%nat, [0; 0; 0; 0x1p-1; 0x143c64623775d5p-53; 0x3p-2; 1; 1; 1],
 [(2%nat, 0, [1; 0; 0]);
  (5%nat, 1, [0; 0; 1]);
  (4%nat, 0x143c64623775d5p-53, [0x3c39b9dc88a2bp-51; 0x43c64623775d5p-51; 0]);
  (5%nat, 0xdp-4, [0x30f669a66f403p-51; 0x4709965990bfdp-51; 0x1p-4]);
  (4%nat, 0x16fde9427f2401p-53, [0x114807a374c21dp-57; 0xcb7325e6cb06fp-52; 0x57d1ac8ef5301p-53]);
  (2%nat, -1, [1; 0; 0]);
  (5%nat, 0xfffffffffffffp-52, [0x570b667d378e9p-151; 0xffffffffffffdp-101; 0x1ffffffffffffp-49])]);
(2%nat, [0; 0; 0; 0x1p-960; 0x1p-960; 0x10000000000001p-1012; 1; 1; 1],
 [(2%nat, 0, [1; 0; 0]);
  (5%nat, 1, [0; 0; 1]);
  (4%nat, 0x1p-960, [1; 0; 0]);
  (5%nat, 0x7p-3, [0x1p-6; 0x7p-5; 0x31p-6]);
  (5%nat, 0x93a4355531277p-53, [0x1034a949fb90c7p-53; 0x1a444d82c57307p-54; 0xaa4bfd286d6d5p-55]);
  (2%nat, -1, [1; 0; 0]);
  (5%nat, 0x3ffffffffffffp-50, [0x1p-100; 0x3ffffffffffffp-99; 0x1ffffffffffffp-49])]);
(2%nat, [-0xfp-2; -0x7p-1; -3; -2; -0x1p-2; 0; 0x1p-1; 0x3p-1; 2; 3],
 [(2%nat, -3, [0x15555555555555p-53; 0x15555555555555p-54; 0]);
  (6%nat, 0x3p-1, [0; 0x15555555555555p-54; 0x15555555555555p-53]);
  (5%nat, 0, [0x15555555555555p-53; 0x15555555555555p-54; 0]);
  (3%nat, -0x1dp-5, [0x2dd1745d1745dp-53; 0x919745d1745d1p-52; 0xafp-9]);
  (6%nat, 0x5f8f7c8a10665p-51, [0x183862b27eef39p-54; 0x252f923ef732bp-50; 0x530161d13bc3p-51]);
  (2%nat, -0xfp-1, [0x15555555555555p-53; 0x15555555555555p-54; 0]);
  (6%nat, 0xbfffffffffff9p-51, [0x82aaaaaaaaaabp-148; 0xaaaaaaaaaaadp-49; 0x1555555555553p-49])]);
(2%nat, [0; 0; 0; 0x9p-535; 0x27p-537; 0x280c95662056dp-581; 0x1p-531; 0x1p-531; 0x1p-531],
 [(2%nat, 0, [1; 0; 0]);
  (5%nat, 0x1p-531, [0; 0; 1]);
  (3%nat, 0x9p-535, [0x4ec4ec4ec4ec5p-54; 0x1d89d89d89d89dp-53; 0]);
  (2%nat, 0x9p-536, [0x1p-2; 0x213b13b13b13bp-50; 0x1d89d89d89d89dp-55]);
  (5%nat, 0x2ff4c80f5f275p-581, [0xdc1a37647f511p-53; 0x760c2960da8ffp-52; 0x1be6baece5c785p-56]);
  (2%nat, -0x1p-531, [1; 0; 0]);
  (5%nat, 0x3ffffffffffffp-581, [0x1b5cda770a17fbp-150; 0xab045567ff157p-99; 0xfffffffffffebp-52])]);
(2%nat, [-0x1dcd65p9; -0x1dcd65p9; -0x1dcd65p9; -0x3b9ac9ff7p-4; -0xee6b27fd9p-6; -0x1dcd64ffafe6d5p-23; -0x3b9ac9ffp0; -0x3b9ac9ffp0; -0x3b9ac9ffp0],
 [(2%nat, -0x1dcd65p9, [1; 0; 0]);
  (5%nat, -0x3b9ac9ffp0, [0; 0; 1]);
  (4%nat, -0xee6b27fd9p-6, [0x10952cb281ea89p-54; 0x17b569a6bf0abbp-53; 0]);
  (3%nat, -0x773593fed1p-9, [0xb13b13b13b13bp-58; 0xb324298826123p-52; 0x1285ba8a454063p-54]);
  (2%nat, -0x1dcd64ffd14efp-19, [0xfd0ac0722c3f3p-55; 0x3e7ee9b0a2e31p-51; 0x18d835241d2c7dp-54]);
  (2%nat, -0x3b9aca01p0, [1; 0; 0])]);
(2%nat, [0; 0; 0; 0x1p-77; 0x1b71d8fa22fc71p-55; 0x1be361b762a127p-53; 0x1ffffffffffffp-49; 1; 1; 1],
 [(2%nat, 0, [1; 0; 0]);
  (6%nat, 1, [0; 0; 1]);
  (6%nat, 0x1ffffffffffffp-49, [0x1f214735ea0a01p-99; 0x1fffffffffff83p-53; 0]);
  (3%nat, 0x149562bb9a3d55p-55, [0x1fffffffffffffp-57; 0x3324a3afa357fp-50; 0x11b6b8a0b95021p-55]);
  (3%nat, 0x15f0972c9fabp-53, [0x1f34a08809daabp-53; 0xcb0ef7f29f0b7p-57; 0x142000e1924305p-67]);
  (2%nat, -1, [1; 0; 0]);
  (6%nat, 0x3ffffffffffffp-50, [0x1f214735ea0a01p-101; 0x17ffffffffffe1p-53; 0x1p-2])]);
(2%nat, [-1; -1; -1; -0; 0; 0xbee6dc5dc9be1p-52; 0xbee6dc5dc9be1p-52; 1; 1; 1],
 [(2%nat, -1, [1; 0; 0]);
  (6%nat, 1, [0; 0; 1]);
  (4%nat, -0, [1; 0; 0]);
  (2%nat, -0x3p-2, [0x9p-4; 0x3p-3; 0x1p-4]);
  (2%nat, -0x8889c5470cdfp-50, [0x1234aaf00eefc9p-58; 0xecaa34adfbde7p-54; 0xc04848187d4c7p-52]);
  (2%nat, -3, [1; 0; 0]);
  (6%nat, 0x1ffffffffffffp-49, [0x7bb7bd6cba9e3p-145; 0xfbae6a14f3241p-98; 0xfffffffffffc1p-52])]);
(4%nat, [0; 0; 0; 0; 0; 0x15p-5; 0xaf9638c020d6dp-52; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (6%nat, 1, [0; 0; 0; 0; 1]);
  (6%nat, 0xaf9638c020d6dp-52, [0x5c53336ea646bp-54; 0x1ac88aebcf0e5p-50; 0xfb3e10f05807p-49; 0x14ff7e7718c7e3p-63; 0]);
  (4%nat, 0x3fp-7, [0x1p-8; 0x3a2a67fc106bp-50; 0x1986c91ec1e925p-54; 0x1a3e77779f9ef5p-54; 0x42c0c74eeb89bp-53]);
  (4%nat, 0x14312d417a6723p-53, [0x12603eeb216421p-71; 0xeb6e8d46317d7p-62; 0x159bcb280fdc3fp-55; 0xf4c5a64e3313fp-53; 0x5a2a9624f75afp-52]);
  (4%nat, -1, [1; 0; 0; 0; 0]);
  (6%nat, 0x3ffffffffffffp-50, [0x1285c3776a823fp-249; 0x942e1bbb5411bp-196; 0xde452998fe19fp-146; 0x1977ecc43272ddp-99; 0x7ffffffffffe7p-51])]);
(4%nat, [0; 0; 0; 0; 0; 0x156d5bc34ec8bp-52; 0x891cb85d07bf3p-54; 0xbp-6; 0xdp-5; 0x23p-6; 0x17046f6c0af051p-53; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (10%nat, 1, [0; 0; 0; 0; 1]);
  (6%nat, 0x891cb85d07bf3p-54, [0x158800600b7705p-58; 0x13e20b7658376fp-53; 0x591853375231p-48; 0x4eaa1fbd26b83p-57; 0]);
  (6%nat, 0x1391cb85d07bf3p-55, [0x158800600b7705p-62; 0x7d8956e01cee1p-52; 0x796963349eb13p-52; 0x8b3bdab16fb91p-56; 0x1b41f569ba0089p-67]);
  (10%nat, 0x79919f5314cbdp-51, [0x356bdce10f5a3p-63; 0x1885b49baeb4c7p-60; 0xbae2a704e9229p-55; 0x1cb0f55c277709p-54; 0x7450cce96df25p-52]);
  (4%nat, -1, [1; 0; 0; 0; 0]);
  (10%nat, 0x1ffffffffffff9p-53, [0x95f61238d25a7p-248; 0x11bdaeba269985p-197; 0x907645a2a8065p-146; 0x18efd835fb7aebp-99; 0x7ffffffffffe7p-51])]);
(4%nat, [0; 0; 0; 0; 0; 0x1p-2; 0x1p-1; 0x1p-1; 0x1p-1; 0x71b0987f1ff21p-51; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (9%nat, 1, [0; 0; 0; 0; 1]);
  (8%nat, 0x1p-1, [0x4ddbef22798e9p-51; 0x1912086ec338b9p-54; 0; 0; 0]);
  (5%nat, 0x3p-3, [0x1p-7; 0xbp-7; 0x2bp-7; 0x8bbb7de44f31dp-52; 0x1912086ec338b9p-58]);
  (4%nat, 0x7f7f37fc75273p-53, [0x1064ed224a45p-76; 0x1040c56eed162bp-55; 0x6080042400f19p-52; 0xbefcee5209ce9p-53; 0x1f7ff9d419ac05p-56]);
  (4%nat, -1, [1; 0; 0; 0; 0]);
  (9%nat, 0xffffffffffffdp-52, [0x5a90a00f18fabp-246; 0x1e30355a5da8dp-193; 0x1e30355a5da8b5p-147; 0xd6ac2610d2e75p-97; 0x3ffffffffffe5p-50])]);
(4%nat, [0; 0; 0; 0; 0; 0x1p-1; 0x10000000000001p-53; 0x8000000000001p-52; 0x8000000000001p-52; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (8%nat, 1, [0; 0; 0; 0; 1]);
  (6%nat, 0x10000000000001p-53, [0x3ffffffffffffp-155; 0x4ffffffffffffp-102; 0x7ffffffffffffp-51; 0x1p-54; 0]);
  (4%nat, 0x1p-2, [0x1p-4; 0x8000000000001p-53; 0xc000000000001p-53; 0x7ffffffffffffp-53; 0xffffffffffffbp-56]);
  (8%nat, 0x1032474e973b55p-53, [0x1e751e067c7249p-53; 0xc1cc74e938ad9p-56; 0x39cd82e206287p-60; 0xf532486a42eefp-69; 0x6182a7987f0a3p-76]);
  (4%nat, -1, [1; 0; 0; 0; 0]);
  (8%nat, 0x3ffffffffffffp-50, [0x10000000000005p-248; 0xffffffffffffdp-197; 0xbfffffffffff7p-147; 0x7fffffffffff5p-98; 0x7fffffffffffp-47])]);
(4%nat, [-0xfp-2; -3; -3; -0x5p-1; -0x9p-2; -0x3p-1; -0x5p-2; 0x1p-1; 0x3p-2; 0x5p-2; 0x7p-2; 2; 0x9p-2; 0x7p-1; 0xfp-2],
 [(4%nat, -0x9p-2, [0x3p-4; 0x841d41d41d41dp-52; 0x12b46b46b46b47p-54; 0x11111111111111p-60; 0]);
  (9%nat, 0x7p-2, [0; 0x16c16c16c16c17p-59; 0x105b05b05b05bp-50; 0xa8c536fe1a8c5p-52; 0x25ed097b425edp-53]);
  (5%nat, -0x3p-1, [0xea0ea0ea0ea0fp-59; 0x228c85dfa3cbbp-50; 0x337142b7142b7p-51; 0xd1745d1745d17p-56; 0]);
  (5%nat, -0x17p-4, [0x1283a83a83a83bp-61; 0xf78e5d88c1463p-53; 0x38cefc08f6ddp-47; 0x1206692883045p-52; 0xa57eb50295fadp-69]);
  (8%nat, 0x7df4ba4fb0963p-51, [0x1fcd0ae13a2293p-62; 0x57898dafe349bp-53; 0x585700a8ff0b3p-51; 0x4478a000104f7p-53; 0x1a3675506690b1p-61]);
  (4%nat, -0x19p-2, [0x3p-4; 0x841d41d41d41dp-52; 0x12b46b46b46b47p-54; 0x11111111111111p-60; 0]);
  (9%nat, 0x1bfffffffffff3p-52, [0x7701111111111p-245; 0xb60b60b60b69fp-58; 0x82d82d82d82fdp-53; 0x1518a6dfc3517p-49; 0x12f684bda12eedp-56])]);
(4%nat, [0; 0; 0; 0; 0; 0x10034077e577e9p475; 0x14bc3a326df343p478; 0x1p531; 0x1p531; 0x1p531; 0x1p531; 0x1p531],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (6%nat, 0x1p531, [0; 0; 0; 0; 1]);
  (6%nat, 0x14bc3a326df343p478, [0xbe99d2f9c070dp-56; 0x81fa03318a767p-53; 0xe981339117373p-53; 0x1f2c63b7899113p-55; 0]);
  (5%nat, 0xdb5cb652379a9p478, [0x7778122f0c8c9p-57; 0x24173c5ea12c9p-51; 0xdbadf5b1d1201p-53; 0x1e5daff4fceb83p-55; 0x1306d7dcc5b6cdp-57]);
  (6%nat, 0x1f2c0cb5ff8265p478, [0xb63ff8d310a07p-71; 0x1a76e71c47a239p-65; 0x5b7462f1209abp-57; 0x203a062e17dedp-51; 0x5e517f285cffbp-51]);
  (4%nat, -0x1p531, [1; 0; 0; 0; 0]);
  (6%nat, 0x1ffffffffffff9p478, [0x38d755527e59p-245; 0x103d861791d043p-199; 0x1bd72f03d564fbp-149; 0x27c526ec81f1fp-96; 0x1fffffffffffb1p-53])]);
(4%nat, [0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0x1dcd65p9; 0xee6b2800400dp-18; 0x1dcd650052f0e9p-23; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0; 0x3b9aca01p0],
 [(4%nat, 0x1dcd65p9, [1; 0; 0; 0; 0]);
  (6%nat, 0x3b9aca01p0, [0; 0; 0; 0; 1]);
  (5%nat, 0xee6b2800400dp-18, [0x17994c8617720bp-53; 0x7da2e582392f3p-53; 0x44b68c8d1c751p-56; 0x6301155843121p-62; 0]);
  (6%nat, 0x1dcd65005e34afp-23, [0x789d520030f71p-57; 0x116b662fac9aa1p-55; 0xd9a5d1d91e4f3p-53; 0x1ae4580357135dp-54; 0x200002d739bedp-57]);
  (5%nat, 0xee6b28027f847p-22, [0x1fd7ddd36ad6cbp-72; 0x7b553923d5935p-55; 0x492c782e4bd69p-52; 0xe4ef10ec79991p-53; 0x1a789c2f8f6b8dp-55]);
  (4%nat, 0x3b9ac9ffp0, [1; 0; 0; 0; 0])]);
(4%nat, [0; 0; 0; 0; 0; 0x1p-132; 0x15cf3415727a35p-54; 0x35p-6; 0x7fffffffffp-39; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (8%nat, 1, [0; 0; 0; 0; 1]);
  (6%nat, 0x15cf3415727a35p-54, [0x1a16bb4e1eaecbp-55; 0x7b221b123d14dp-52; 0x111d315a127b73p-54; 0x187751d2773f8fp-57; 0]);
  (5%nat, 0x20b6ce202bb75p-52, [0x271p-12; 0x1384040c9bc1dfp-53; 0xd9ef4c66eaa99p-54; 0xc2c3cf49511adp-57; 0x1ef7038e5eec73p-63]);
  (7%nat, 0xf5b3d57c16b91p-52, [0x183a70fc01d5d9p-68; 0x221c7b9085789p-58; 0x22b1b97038c6bp-53; 0x4aff2d4700b9dp-51; 0x1607b4c92414c3p-54]);
  (4%nat, -1, [1; 0; 0; 0; 0]);
  (8%nat, 0x3ffffffffffffp-50, [0x8d3641d2fe02fp-209; 0x8d31d820ef6abp-157; 0x22e5d18ba2e89p-105; 0x1ffa007ffbffbbp-62; 0xff8017fe001p-44])]);
(4%nat, [-1; -1; -1; -1; -1; -0; 0; 0xb8c99e1beb8f3p-54; 0x1fp-6; 1; 1; 1; 1; 1],
 [(4%nat, -1, [1; 0; 0; 0; 0]);
  (8%nat, 1, [0; 0; 0; 0; 1]);
  (8%nat, 0x1fp-6, [0x156940df76083dp-55; 0xde80f84b68ec3p-53; 0x1637b274cfbd8fp-54; 0xd0e384820832dp-56; 0]);
  (8%nat, 0x19dp-9, [0xd8c9b0d68b137p-60; 0xd26205b210e87p-56; 0x12402c4e256211p-54; 0x103e0c976e5bc5p-53; 0x271p-12]);
  (4%nat, -0xe3da67acdf729p-52, [0xa0a83ea58f17bp-52; 0x9ec4cd7da7827p-53; 0x772a55581fdcdp-55; 0x854c5c2d646b5p-59; 0x577383e62a197p-64]);
  (4%nat, -3, [1; 0; 0; 0; 0]);
  (8%nat, 0x7ffffffffffffp-51, [0x9773a069a06fbp-254; 0x12ee740d340df3p-202; 0xe32d709e70a73p-150; 0x1f07c1f07c1ef5p-101; 0xffffffffffffp-48])]);
(1%nat, [0; 0; 0x1p-1022; 0x1p-1021; 0x3p-1022; 0x1p-1020; 0x5p-1022; 0x5p-1022],
 [(1%nat, 0, [1; 0]);
  (5%nat, 0x5p-1022, [0; 1]);
  (4%nat, 0x3p-1022, [1; 0]);
  (1%nat, 0x1p-1025, [0x7p-3; 0x1p-3]);
  (1%nat, 0x1f764cee09503p-1074, [0xe089b311f6afdp-52; 0x1f764cee09503p-52]);
  (1%nat, -0x5p-1022, [1; 0]);
  (5%nat, 0x13fffffffffffbp-1072, [0x5p-50; 0x3fffffffffffbp-50])]);
(1%nat, [-0x1p-1021; -0x1p-1021; -0x1p-1022; 0; 0x1p-1022; 0x1p-1021; 0x1p-1021],
 [(1%nat, -0x1p-1021, [1; 0]);
  (4%nat, 0x1p-1021, [0; 1]);
  (3%nat, 0, [1; 0]);
  (2%nat, -0x1p-1025, [0x1p-3; 0x7p-3]);
  (3%nat, 0x3bf2ad2fdc29bp-1073, [0x440d52d023d65p-51; 0x3bf2ad2fdc29bp-51]);
  (1%nat, -0x3p-1021, [1; 0]);
  (4%nat, 0x7fffffffffffdp-1072, [0x3p-50; 0x3fffffffffffdp-50])]);
(2%nat, [0; 0; 0; 0x1p-1022; 0x1p-1021; 0x3p-1022; 0x1p-1020; 0x5p-1022; 0x5p-1022; 0x5p-1022],
 [(2%nat, 0, [1; 0; 0]);
  (6%nat, 0x5p-1022, [0; 0; 1]);
  (6%nat, 0x1p-1020, [0x1p-1; 0x1p-1; 0]);
  (5%nat, 0x19p-1025, [0x31p-7; 0x27p-6; 0x1p-7]);
  (2%nat, 0x5ebe74b5e60bp-1072, [0xd2d1cc5b7d7cfp-52; 0xb056c12529077p-54; 0x118835b3841373p-60]);
  (2%nat, -0x5p-1022, [1; 0; 0]);
  (6%nat, 0x9ffffffffffffp-1071, [0x1p-99; 0x7fffffffffffdp-99; 0xffffffffffffp-48])]);
(2%nat, [-0x1p-1021; -0x1p-1021; -0x1p-1021; -0x1p-1022; 0; 0x1p-1022; 0x1p-1021; 0x1p-1021; 0x1p-1021],
 [(2%nat, -0x1p-1021, [1; 0; 0]);
  (5%nat, 0x1p-1021, [0; 0; 1]);
  (4%nat, 0, [0x1p-1; 0x1p-1; 0]);
  (3%nat, -0x3p-1024, [0x9p-5; 0xbp-4; 0x1p-5]);
  (5%nat, 0xd2897d5d8d249p-1073, [0x1025c1939998d7p-56; 0x10ad18b9dfd467p-53; 0x1a9c5e2759f0fbp-54]);
  (2%nat, -0x3p-1021, [1; 0; 0]);
  (5%nat, 0x7fffffffffffdp-1072, [0x9p-101; 0xbfffffffffff9p-99; 0x1fffffffffffdp-49])]);
(3%nat, [0; 0; 0; 0; 0x1p-1022; 0x1p-1021; 0x3p-1022; 0x1p-1020; 0x5p-1022; 0x5p-1022; 0x5p-1022; 0x5p-1022],
 [(3%nat, 0, [1; 0; 0; 0]);
  (7%nat, 0x5p-1022, [0; 0; 0; 1]);
  (7%nat, 0x1p-1020, [0x15555555555555p-55; 0x9555555555555p-52; 0x1p-2; 0]);
  (6%nat, 0x19p-1025, [0x1c955555555555p-56; 0x14dd5555555555p-53; 0x1e3p-11; 0x1p-11]);
  (7%nat, 0x4a765d5b44873p-1070, [0x1c4d668a58e893p-60; 0x9113ae8397687p-54; 0x9262b58c93c17p-52; 0x11e4e21a783579p-54]);
  (3%nat, -0x5p-1022, [1; 0; 0; 0]);
  (7%nat, 0x9ffffffffffffp-1071, [0x15555555555555p-202; 0x2ffffffffffffp-147; 0xbfffffffffff7p-99; 0x1fffffffffffdp-49])]);
(3%nat, [-0x1p-1021; -0x1p-1021; -0x1p-1021; -0x1p-1021; -0x1p-1022; 0; 0x1p-1022; 0x1p-1021; 0x1p-1021; 0x1p-1021; 0x1p-1021],
 [(3%nat, -0x1p-1021, [1; 0; 0; 0]);
  (6%nat, 0x1p-1021, [0; 0; 0; 1]);
  (4%nat, -0x1p-1022, [0x1p-2; 0x9555555555555p-52; 0x15555555555555p-55; 0]);
  (4%nat, -0x1p-1023, [0x1p-5; 0xfp-5; 0xf555555555555p-53; 0x15555555555555p-58]);
  (3%nat, -0x1611b15cfea17p-1070, [0x37e33ae1067d1p-54; 0x118021b4aba1ffp-53; 0x5bd261a121133p-52; 0x28cf080500f65p-54]);
  (3%nat, -0x3p-1021, [1; 0; 0; 0]);
  (6%nat, 0x7fffffffffffdp-1072, [0x9p-151; 0x6bffffffffffdp-147; 0x47ffffffffffbp-97; 0x3fffffffffff7p-50])]);
(0%nat, [0; 1],
 [(0%nat, 0, [1]);
  (0%nat, 1, [1]);
  (0%nat, 0x5p-3, [1])]);
(0%nat, [0; 0x2fp-6; 0x39f8c1282144dp-50; 1],
 [(0%nat, 0, [1]);
  (2%nat, 1, [1]);
  (2%nat, 0x39f8c1282144dp-50, [1]);
  (2%nat, 0x79f8c1282144dp-51, [1])]);
(1%nat, [0; 0; 1; 1],
 [(1%nat, 0, [1; 0]);
  (1%nat, 1, [0; 1]);
  (1%nat, 0x1p-3, [0x7p-3; 0x1p-3])]);
(1%nat, [0; 0; 0x1af8a5698a8411p-54; 0x15ff7206076907p-53; 1; 1],
 [(1%nat, 0, [1; 0]);
  (3%nat, 1, [0; 1]);
  (3%nat, 0x15ff7206076907p-53, [1; 0]);
  (2%nat, 0x1f3a35122b979p-50, [0x18000000000001p-53; 0xfffffffffffffp-54])]);
(1%nat, [0; 0; 0x1p-1; 1; 1],
 [(1%nat, 0, [1; 0]);
  (2%nat, 1, [0; 1]);
  (2%nat, 0x1p-1, [1; 0]);
  (2%nat, 0xdp-4, [0x3p-3; 0x5p-3])]);
(2%nat, [0; 0; 0; 1; 1; 1],
 [(2%nat, 0, [1; 0; 0]);
  (2%nat, 1, [0; 0; 1]);
  (2%nat, 0x7p-3, [0x1p-6; 0x7p-5; 0x31p-6]);
  (2%nat, -1, [1; 0; 0]);
  (2%nat, 0x1p-1074, [1; 0x1p-1073; 0]);
  (2%nat, 0xa2a7ae05abb6fp-52, [0x1104a5042bcbb3p-55; 0x1da783f8fe58d5p-54; 0x19d62984ebc151p-54]);
  (2%nat, 0x66fc2203ac765p-51, [0x4e382d47970f5p-55; 0x14205b27da18bbp-54; 0x14b6f1b6f49765p-53]);
  (2%nat, 0x1fffffffffffffp-53, [0x1p-106; 0x1fffffffffffffp-105; 0xfffffffffffffp-52]);
  (2%nat, 2, [0; 0; 1])]);
(2%nat, [0; 0; 0; 0x7p-4; 0xffb99936d8a47p-53; 1; 1; 1],
 [(2%nat, 0, [1; 0; 0]);
  (4%nat, 1, [0; 0; 1]);
  (4%nat, 0xffb99936d8a47p-53, [0x1c7999a4929865p-53; 0x1c3332db6b3cd5p-56; 0]);
  (2%nat, 0x15p-6, [0x1p-4; 0xe3ba9fbdd04b3p-53; 0x1f88ac0845f699p-54])]);
(2%nat, [0; 0; 0; 0x1p-1; 0x1p-1; 1; 1; 1],
 [(2%nat, 0, [1; 0; 0]);
  (4%nat, 1, [0; 0; 1]);
  (4%nat, 0x1p-1, [1; 0; 0]);
  (4%nat, 0xdp-4, [0x9p-6; 0xfp-5; 0x19p-6])])].

Definition rows_7 : list (nat * list float * list (nat * float * list float)) := [
(3%nat, [0; 0; 0; 0; 0xa1c2e649ec617p-56; 0x16e1ccd154c15bp-53; 1; 1; 1; 1],
 [(3%nat, 0, [1; 0; 0; 0]);
  (5%nat, 1, [0; 0; 0; 1]);
  (5%nat, 0x16e1ccd154c15bp-53, [0x2b471f82f5465p-53; 0x6bb7e358a137dp-52; 0x7ea48ce5e4251p-52; 0]);
  (5%nat, 0x1a4d2002d4f8d9p-53, [0x5486e98bc70d5p-56; 0x3babf93c033fp-48; 0xb18b982b40503p-52; 0x6c00000000001p-55])]);
(4%nat, [0; 0; 0; 0; 0; 0x7p-4; 0x37p-6; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (6%nat, 1, [0; 0; 0; 0; 1]);
  (5%nat, 0x7p-4, [0xf249e8d94ce31p-55; 0xd943b7613e6c5p-53; 0xb845bbca2d31p-49; 0xc7904a7904a79p-55; 0]);
  (4%nat, 0x7p-5, [0x1p-4; 0x8071915d6b2cbp-52; 0x167efd92cfb08dp-54; 0x2806af84c80f9p-53; 0xc7904a7904a79p-59])]);
(4%nat, [0; 0; 0; 0; 0; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 1; 1; 1; 1; 1],
 [(4%nat, 0, [1; 0; 0; 0; 0]);
  (8%nat, 1, [0; 0; 0; 0; 1]);
  (8%nat, 0x1p-1, [1; 0; 0; 0; 0]);
  (4%nat, 0x1p-2, [0x1p-4; 0x1p-2; 0x3p-3; 0x1p-2; 0x1p-4])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x109a786ea55693p-53; 0xa3bf92aba9ce3p-52; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 0; 0; 1]);
  (7%nat, 0xa3bf92aba9ce3p-52, [0x23e399e0531bp-50; 0x1b039c22608ff7p-55; 0x37acc82c691b7p-51; 0x14288241cae8a7p-54; 0x8223f1961febp-55; 0]);
  (6%nat, 0x8c8eb742ca7bp-48, [0x278c6b625b295p-61; 0xda8d6d008175p-51; 0xb2de116484cddp-53; 0xc95d9c772421bp-53; 0x99f1d0a9c583fp-54; 0x8223f1961febbp-69])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 1; 1; 1; 1; 1; 1],
 [(5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (10%nat, 1, [0; 0; 0; 0; 0; 1]);
  (10%nat, 0x1p-1, [1; 0; 0; 0; 0; 0]);
  (5%nat, 0x7p-4, [0x1p-15; 0x23p-15; 0xf5p-14; 0x6b3p-14; 0x2ee5p-15; 0x41a7p-15])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (6%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (6%nat, 0x5p-3, [0x2d9p-18; 0xe3dp-17; 0x76a7p-18; 0x41ebp-16; 0x14997p-18; 0x6dddp-17; 0x3d09p-18]);
  (6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (6%nat, 0xfc8cb61e0161fp-53, [0x8ab4c5f7e3d41p-57; 0x6543401f0daa5p-54; 0xf66c66d131e01p-54; 0x4ff4d7588614dp-52; 0x1d2fa8b98e2e85p-55; 0xb5d2c4fd99a7fp-55; 0x1d7f7546dabf8dp-59]);
  (6%nat, 0x1b9ad2076fbbddp-53, [0xe14a276be08d5p-69; 0x1094df947cb1abp-64; 0x208b617086e9fp-57; 0x884422087339fp-56; 0xa07817e0e1a8dp-54; 0x64c8d3de98c6fp-52; 0xd2ff06f0f6629p-53]);
  (6%nat, 0x1fffffffffffffp-53, [0x1p-318; 0x17ffffffffffffp-315; 0x1dfffffffffffdp-261; 0x9ffffffffffffp-206; 0x77fffffffffffp-153; 0x17fffffffffffbp-103; 0xffffffffffffdp-52]);
  (6%nat, 0x10000000000001p-52, [0; 0; 0; 0; 0; 0; 1]);
  (6%nat, 2, [0; 0; 0; 0; 0; 0; 1])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x12a86c24afe5ddp-54; 0x7p-4; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (8%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (8%nat, 0x7p-4, [0xa2c996975efc5p-55; 0x46c273b9d227dp-52; 0x177e9f3a566ed7p-54; 0xe44736009225p-50; 0x1b7f739e6c047p-53; 0xc2a9d46d8e475p-63; 0]);
  (7%nat, 0x13d35ea019e921p-54, [0x799b89df07207p-60; 0x1127682140a0ffp-54; 0xd2305f1069ddbp-53; 0x7dd72f0ced31fp-53; 0x111eefa73d4cedp-56; 0x1c60d352051997p-60; 0x18553a8db1c8bdp-82])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (12%nat, 1, [0; 0; 0; 0; 0; 0; 1]);
  (12%nat, 0x1p-1, [1; 0; 0; 0; 0; 0; 0]);
  (6%nat, 0x3p-3, [0x1p-12; 0x9p-11; 0x87p-12; 0x87p-10; 0x4bfp-12; 0x2d9p-11; 0x2d9p-12])]);
(7%nat, [0; 0; 0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1; 1; 1],
 [(7%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0]);
  (7%nat, 1, [0; 0; 0; 0; 0; 0; 0; 1]);
  (7%nat, 0x1p-3, [0xc90f7p-21; 0xc90f7p-21; 0x562b3p-21; 0x14843p-21; 0x2ee5p-21; 0x405p-21; 0x31p-21; 0x1p-21])]);
(7%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0x18e2f29a418837p-56; 0x1fp-5; 1; 1; 1; 1; 1; 1; 1; 1],
 [(7%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0]);
  (9%nat, 1, [0; 0; 0; 0; 0; 0; 0; 1]);
  (9%nat, 0x1fp-5, [0x46e43e8ab1ab5p-80; 0x19bd199c414515p-75; 0x1f24862663e973p-69; 0xa0b5578e39b63p-62; 0x748748603d341p-57; 0xb3e38a5dcf73fp-54; 0x679cdcb7b2003p-51; 0]);
  (7%nat, 0x15c69446f9573p-52, [0x8000000000001p-72; 0x958c18af807ebp-52; 0xa967dc774c277p-53; 0x1340bc34a8c939p-56; 0x25505398cfeafp-56; 0xa2bce04f03d7dp-62; 0xbd5890cba84bbp-67; 0x16f5b9358b1753p-74])]);
(7%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(7%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0]);
  (14%nat, 1, [0; 0; 0; 0; 0; 0; 0; 1]);
  (14%nat, 0x1p-1, [1; 0; 0; 0; 0; 0; 0; 0]);
  (7%nat, 0x1p-3, [0x88bp-14; 0x13efp-14; 0x13efp-14; 0xb13p-14; 0x3b1p-14; 0xbdp-14; 0x15p-14; 0x1p-14])]);
(8%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(8%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0]);
  (8%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (8%nat, 0x1p-1, [0x1p-8; 0x1p-5; 0x7p-6; 0x7p-5; 0x23p-7; 0x7p-5; 0x7p-6; 0x1p-5; 0x1p-8])]);
(8%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0x17p-6; 0x1988174b7a1b49p-54; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(8%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0]);
  (10%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (9%nat, 0x17p-6, [0x194bf97608c771p-76; 0x96e151ca8b75dp-55; 0x3d8af339cb677p-52; 0x14f2ace8acba25p-54; 0x3ceb23a45e6b9p-52; 0xc78402e092f89p-55; 0x15cd6d9c187a07p-58; 0x1fcb7b7e702e1fp-62; 0]);
  (9%nat, 0x175102e96f4369p-54, [0x116267b636f46fp-77; 0x11b9fab1844697p-56; 0xee433917fd023p-54; 0x14ded07b26ac53p-54; 0x1f3a48a1b232fbp-55; 0xd26ea97b0490bp-55; 0x17a6bc8e8924ddp-58; 0x11bbdf4ce91561p-61; 0x3aca4b310f351p-102])]);
(8%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(8%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0]);
  (16%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (16%nat, 0x1p-1, [1; 0; 0; 0; 0; 0; 0; 0; 0]);
  (16%nat, 0x3p-2, [0x1p-8; 0x1p-5; 0x7p-6; 0x7p-5; 0x23p-7; 0x7p-5; 0x7p-6; 0x1p-5; 0x1p-8])]);
(9%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(9%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (9%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (9%nat, 0x7p-3, [0x1p-27; 0x3fp-27; 0x1b9p-25; 0x1c23p-25; 0x24edfp-26; 0x102819p-26; 0x25b2e5p-25; 0x7118afp-25; 0x317acc9p-27; 0x267bf47p-27])]);
(9%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0xbp-4; 0x1615a69e9c3ad1p-53; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(9%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (11%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (11%nat, 0x1615a69e9c3ad1p-53, [0x47483f8860a79p-62; 0x11653e7e54ac91p-60; 0x3a3822ab61e4fp-55; 0x6c3fe72268ff7p-54; 0x1e30ec2f4d7411p-55; 0x1435807b999e37p-54; 0x3c1f18b43f095p-52; 0x1329e8e8f1b649p-56; 0x1e2d65ba85dad3p-108; 0]);
  (11%nat, 0x7615a69e9c3adp-51, [0x47483f8860a7dp-80; 0x1c9ca04bb035c5p-76; 0xa1b5227d3ad6dp-69; 0x106cd474c41ff1p-65; 0x10cc7eaf6ae92fp-61; 0xb1162f5aef09fp-57; 0x4920fc47e3bc1p-53; 0x10f9aa4e7b7c49p-53; 0xe9474393551bp-50; 0x99c5ffffffffdp-55])]);
(9%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(9%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (18%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (18%nat, 0x1p-1, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (18%nat, 0xdp-4, [0x4ce3p-27; 0x4814dp-27; 0x7822bp-25; 0x1d3319p-25; 0x91ff7dp-26; 0xf3547bp-26; 0x872eefp-25; 0x608f3dp-25; 0xa0eebbp-27; 0x1dcd65p-27])]);
(10%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(10%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (10%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (10%nat, 0x1p-1, [0x1p-10; 0x5p-9; 0x2dp-10; 0xfp-7; 0x69p-9; 0x3fp-8; 0x69p-9; 0xfp-7; 0x2dp-10; 0x5p-9; 0x1p-10])]);
(10%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0xdp-5; 0x113adc5cfab2ddp-53; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(10%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (12%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (12%nat, 0x113adc5cfab2ddp-53, [0x1a3c9ec30a4e4fp-62; 0x10181716b2e6ddp-58; 0x1154917dd1cbe7p-56; 0xab3b238c61191p-54; 0x84baba9dd7f09p-53; 0x422d64721cfd7p-52; 0xa5ffb300545d7p-54; 0x1dfb0b0d6a99c3p-57; 0x132b1664c4b1bdp-59; 0x1689f11aafabe3p-72; 0]);
  (11%nat, 0xe0eb7173eacb7p-53, [0x187bab03b0eee7p-75; 0x16f39ac788a1e1p-59; 0x22563e1062c2fp-53; 0x1697bce7ecda63p-55; 0x110f9491ac91bfp-54; 0x1029704bf938bfp-54; 0x13a870ea368039p-55; 0xefc3297e5c1b9p-56; 0x68b2fa940017dp-57; 0xa06210063f33p-57; 0xb44f88d57d5d7p-91])]);
(10%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(10%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (19%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (19%nat, 0x1p-1, [0x1p-1; 0x1p-1; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (19%nat, 0x5p-3, [0xe6a9p-21; 0x6e865p-21; 0x4814dp-20; 0x8025p-17; 0x12b01p-19; 0x3bcdp-18; 0x2139p-19; 0x195p-17; 0x195p-20; 0xfp-19; 0x1p-20])]);
(11%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(11%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (11%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (11%nat, 0x5p-3, [0x2b3fbp-33; 0x318e4fp-33; 0x19cf73dp-33; 0x810d431p-33; 0xd7161a7p-32; 0x1f5de3dbp-32; 0x3447266dp-32; 0x3e3c5251p-32; 0x67b9de87p-33; 0x39a0264bp-33; 0x13356219p-33; 0x2e90eddp-33])]);
(11%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x1a53fed1ad5ab3p-57; 0x7p-6; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(11%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (13%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (13%nat, 0x7p-6, [0x152fb37a817975p-54; 0xc6f5593a59b97p-53; 0x683e2977cb33bp-53; 0x10027258a628afp-56; 0xcb85448b18fffp-58; 0x6c949e1ea5303p-60; 0x137c0b26e3a23fp-65; 0x12320030a1c5fdp-69; 0x509f962d5094bp-72; 0xa33a6079f2c09p-79; 0xcbebdb8e4b0ddp-92; 0]);
  (13%nat, 0x71p-9, [0x4e07ce58bbd65p-54; 0xe54657ad6f035p-54; 0x978eef4b97c85p-53; 0xed46a14fc2cddp-54; 0xf34475a371f9dp-55; 0xaa46fc056a9bp-52; 0x520c190a4cbedp-57; 0x1a9fb1471f5d0fp-62; 0x15c2b4de2c18dbp-65; 0x9594c3e95bf8bp-68; 0x192d1e63e4a237p-76; 0x1p-33])]);
(11%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(11%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (20%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (20%nat, 0x1p-1, [0x1p-2; 0x1p-1; 0x1p-2; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (11%nat, 0x5p-4, [0x2b3fbp-33; 0x318e4fp-33; 0x19cf73dp-33; 0x810d431p-33; 0xd7161a7p-32; 0x1f5de3dbp-32; 0x3447266dp-32; 0x3e3c5251p-32; 0x67b9de87p-33; 0x10fd46c3bp-35; 0xb0f387bp-33; 0x2e90eddp-35])]);
(12%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(12%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (12%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (12%nat, 0x3p-3, [0xe8d4a51p-36; 0x1a3185c5p-34; 0xace072e1p-35; 0xace072e1p-34; 0x3a588d2bfp-36; 0x70062dc5p-33; 0x9cd57347p-34; 0x285424f5p-33; 0x78fc6edfp-36; 0x810d431p-34; 0x2e756a1p-35; 0x288bb5p-34; 0x81bf1p-36])]);
(12%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0xbp-5; 0x1p-1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(12%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (14%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (14%nat, 0x1p-1, [0x30c30c30c30c3p-60; 0x1fed6c8da447fbp-60; 0x96e528a99dc1fp-56; 0x1a7d11b766438fp-56; 0x30fb709fef013p-52; 0x3e57b8d0cbf33p-52; 0x1bac12a4be64e1p-55; 0x8778136606badp-54; 0x6d8234d21154bp-55; 0x1a72a76133dfd3p-59; 0x17441e07269f33p-62; 0x4ad6c55ca32bfp-73; 0]);
  (12%nat, 0x21p-8, [0x1d1a94a2000001p-61; 0x13f989a9fbbea3p-56; 0xd46a5d33f34e1p-53; 0x146cc6bdd70d8fp-54; 0x8c7ccdd29e4cfp-54; 0x4ee6a96a63117p-55; 0xf69b9aa6b6723p-59; 0x44be2c53407d9p-60; 0xdb35822c07c0dp-65; 0x1ea35f24c82e43p-70; 0x16e3512b1e6f79p-74; 0x14906bad03df03p-79; 0x10d57aac96d0c1p-85])]);
(12%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(12%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (21%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (21%nat, 0x1p-1, [0x1p-3; 0x3p-3; 0x3p-3; 0x1p-3; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (21%nat, 0x3p-2, [0x1p-15; 0x1bp-15; 0x13bp-15; 0x801p-15; 0x1efp-12; 0x63p-9; 0xe7p-10; 0x63p-9; 0x1efp-12; 0x37p-10; 0x21p-11; 0x3p-10; 0x1p-12])]);
(13%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(13%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (13%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (13%nat, 0x1p-2, [0x1853d3p-26; 0x696b3dp-26; 0x696b3dp-25; 0x80d867p-25; 0xd6be01p-26; 0x80d867p-26; 0xe50efp-24; 0x4c5a5p-24; 0x4c5a5p-26; 0xe23bp-26; 0xf15p-25; 0x15fp-25; 0x27p-26; 0x1p-26])]);
(13%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x9p-4; 0x33p-6; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(13%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (15%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (15%nat, 0x33p-6, [0x18377019a68125p-79; 0x22a73e09fad5dp-70; 0x16a135abd61829p-69; 0x47428029d40e5p-63; 0x12ccb92d21a48fp-62; 0xdf9c0d2032eb7p-59; 0x1de9a16967ad2dp-58; 0xb8aca50a578adp-55; 0x193f760d8536a5p-55; 0x95bd8afaecc77p-53; 0x8887581e57f1p-49; 0x1d95f64cb55a65p-56; 0x124eee898b951bp-63; 0]);
  (15%nat, 0x1f3p-9, [0x18377019a68125p-118; 0x5d6bd7dc45797p-107; 0x5307074841b21p-99; 0x167fa94bd453b9p-94; 0x84a6661f9cbd1p-86; 0x118853246d7533p-81; 0xda9ce06c25cddp-75; 0x3f6ee30f4493fp-68; 0x1b50ca0a989de3p-66; 0x890b9d352dcb5p-60; 0x1e04dfb82b1729p-58; 0x10d7d3b8b3312fp-54; 0x10ee28c8140473p-53; 0x168f08f8e7p-39])]);
(13%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(13%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (22%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (22%nat, 0x1p-1, [0x1p-4; 0x1p-2; 0x3p-3; 0x1p-2; 0x1p-4; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (22%nat, 0x3p-2, [0x1p-17; 0xfp-16; 0x63p-15; 0x5d9p-16; 0x36f3p-17; 0x507p-13; 0x1adp-11; 0x1adp-11; 0x507p-13; 0x2cbp-13; 0x8fp-12; 0x27p-12; 0xdp-13; 0x1p-13])]);
(14%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(14%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (14%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (14%nat, 0x1p-2, [0x48fb79p-28; 0xaa4ac5p-27; 0x2e1eeabp-28; 0xf5fa39p-26; 0x385ead1p-28; 0x12ca39bp-27; 0x12ca39bp-28; 0xe50efp-25; 0x216783p-28; 0x3b62bp-27; 0x13cb9p-28; 0x999p-26; 0x333p-28; 0x15p-27; 0x1p-28])]);
(14%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x34f452b737363p-52; 0x1c2c53ea45615dp-53; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(14%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (16%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (15%nat, 0x34f452b737363p-52, [0x7dfc8239a613fp-56; 0x9d8d871ba46c9p-54; 0x10b362140c081fp-54; 0x84f8d14d904a5p-53; 0x2c67706fe81f3p-52; 0xa978199e1ac67p-55; 0x773b377a0e4fdp-56; 0xfaf1096a228d3p-59; 0x62d6b3796fd19p-60; 0xe662a36eeab15p-64; 0xc1226cb9d03bfp-67; 0x1b93d08307f467p-72; 0x133d7f1e844befp-76; 0x18c5535d5741f5p-82; 0]);
  (15%nat, 0x16c8e1856dc2b7p-53, [0x1f7f208e69850dp-86; 0x9831c7345c9bbp-73; 0x80ed9accad93p-64; 0x67ed16ca1bd25p-64; 0x6828b8d0103e9p-61; 0x11fdf6b618b9ffp-60; 0x1207a66be587adp-58; 0x1ae0141f0bc88dp-57; 0x1e12ff1776d59p-52; 0xc95d4b5514ac5p-54; 0x1ef3333b6009d7p-55; 0x1ae5e673b1511bp-55; 0x1e93d188a3fc2bp-56; 0x12ee73a805d4e5p-57; 0x8b83651de4533p-60])]);
(14%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(14%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (23%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (23%nat, 0x1p-1, [0x1p-5; 0x5p-5; 0x5p-4; 0x5p-4; 0x5p-5; 0x1p-5; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (23%nat, 0x9p-4, [0x9de93ece51p-47; 0x58d333540d9p-47; 0xa4f5f19c193p-46; 0x13fa62f22493p-46; 0x2949ea908a39p-47; 0x135e83a47971p-47; 0x407db89fbp-42; 0x150eedebp-39; 0x150eedebp-42; 0x100b5ffp-41; 0x24ac49p-42; 0x79edp-40; 0x116bp-42; 0x31p-41; 0x1p-42])]);
(15%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(15%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (15%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (15%nat, 0x5p-3, [0xdaf26bp-45; 0x1561ac73p-45; 0xf9738693p-45; 0x70997af7bp-45; 0x232ff66d67p-45; 0x8105323bcfp-45; 0x16663c46d3fp-45; 0x2fffa5bc587p-45; 0x4fff698f3e1p-45; 0x67b362e9179p-45; 0x67b362e9179p-45; 0x4e8fa805eb1p-45; 0x2ba5247510dp-45; 0x10c95cca905p-45; 0x3ff2e795f5p-45; 0x71afd498dp-45])]);
(15%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x625d50e6d841bp-52; 0x7p-4; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(15%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (17%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (16%nat, 0x625d50e6d841bp-52, [0x161e33cd4b13c7p-95; 0x834434f471bddp-60; 0x105296aac2425fp-58; 0x1dfd5f411255cbp-57; 0x10d7dc44a1414bp-55; 0xce794f5611e0fp-54; 0xe3e1b03c025a5p-54; 0x174bcd49bdb38dp-55; 0x725a31c423c7bp-54; 0x1a51f3e85688cfp-57; 0x8fa45400ee3adp-57; 0x11a4bd975a93dbp-60; 0xbd2fd34f62dfp-58; 0x9b01374bf97bfp-65; 0x75429e482be69p-69; 0]);
  (16%nat, 0x19717f2b488c51p-54, [0x12eaa9e869a69dp-101; 0x17a434bdc580b3p-62; 0x646fbc23360bp-53; 0x189f51aca99c5bp-57; 0x1d846bfc1fbe41p-56; 0x6086d334183c5p-53; 0x1c6a55fb6f7c95p-55; 0x6328e50d9e5c7p-53; 0x81c9d17763f3p-50; 0x3fb76bc4ee4a9p-54; 0xb96607355dfa5p-57; 0x611efbaf212f9p-58; 0x1158f514a44a61p-62; 0x1e4d657d56ac0dp-66; 0x186f249f1e0fd1p-70; 0x17a6b084bb9db1p-132])]);
(15%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(15%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (24%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (24%nat, 0x1p-1, [0x1p-6; 0x3p-5; 0xfp-6; 0x5p-4; 0xfp-6; 0x3p-5; 0x1p-6; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (15%nat, 0x3p-3, [0x1p-30; 0x2dp-30; 0x3b1p-30; 0x2ffdp-30; 0x1afe5p-30; 0xb2281p-30; 0x37ac85p-30; 0xd6be01p-30; 0x2843a03p-30; 0x4553e610dp-36; 0xa91c073p-29; 0x3925680b1p-36; 0x17995059p-32; 0x5f811357p-36; 0xdaf26bp-32; 0xdaf26bp-36])]);
(16%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(16%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (16%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (16%nat, 0x1p-1, [0x1p-16; 0x1p-12; 0xfp-13; 0x23p-12; 0x1c7p-14; 0x111p-12; 0x3e9p-13; 0x2cbp-12; 0x1923p-15; 0x2cbp-12; 0x3e9p-13; 0x111p-12; 0x1c7p-14; 0x23p-12; 0xfp-13; 0x1p-12; 0x1p-16])]);
(16%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x23p-6; 0x132a89e3c2d35p-49; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(16%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (18%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (18%nat, 0x132a89e3c2d35p-49, [0x52b92e648b9adp-69; 0x6d94254999a9fp-65; 0x10da01f74d73cbp-63; 0x1985ab6a1591f1p-61; 0x6a5282cc64071p-57; 0x1423432b7661dfp-57; 0x5b8fd11d4a93p-50; 0x13d44fd3eedca9p-55; 0xd27b21413633p-50; 0x1a9ac8ed932345p-55; 0xa175f46889957p-54; 0x591b7f0d1ffe9p-54; 0x10e8e9e9b620efp-57; 0x1f9b326da0b805p-60; 0x1b6ff18e99d1f1p-63; 0x121abe99e085p-91; 0]);
  (16%nat, 0x69p-9, [0x11c37937e08003p-63; 0x1009cbc4d291e3p-59; 0x7830f1ed69a07p-54; 0xf2944d8fbe301p-54; 0x882e3491ef291p-53; 0xcca75be9fbfd1p-54; 0xde99c0372ed35p-55; 0x5b3c990e71f5bp-55; 0x1ccc7921d61f4bp-59; 0xe23ec7aadf0d7p-60; 0xacf2809953657p-62; 0xcc3aabdba7dffp-65; 0xb6f7f3f2eeecbp-68; 0xf0c88e00caff9p-72; 0x1b7686c07e9d7bp-77; 0x1f12485ee5e429p-82; 0x106dc5f4f074d7p-87])]);
(16%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(16%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (25%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (25%nat, 0x1p-1, [0x1p-7; 0x7p-7; 0x15p-7; 0x23p-7; 0x23p-7; 0x15p-7; 0x7p-7; 0x1p-7; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (25%nat, 0xfp-4, [0x1p-55; 0xe7p-55; 0x6135p-55; 0x194b23p-55; 0x48c4c23p-55; 0x99170e35p-55; 0xf2ee075e7p-55; 0x127614bb101p-55; 0x8a31f9563p-47; 0x6b7c33b4dp-44; 0x41d5ac7859p-45; 0x7daf31fd07p-44; 0x5ba514732a7p-46; 0x3158e3a0795p-44; 0x940aaae16bfp-45; 0x45160b7a437p-44; 0x1e39a5057d81p-48])]);
(17%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(17%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (17%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (17%nat, 0x5p-3, [0x7b285c3p-51; 0xda177895p-51; 0x16b7c73a3p-48; 0xbd50d18f9p-48; 0x8a0aee2359p-49; 0x2562f5d43d7p-49; 0x3e4f99b7111p-48; 0xa332004d2cbp-48; 0x54ff602831f1p-50; 0x8da9a042fde7p-50; 0x2f388ac0ff4dp-48; 0x32152e5092a7p-48; 0x5378a28649c1p-49; 0x3581d7c5abffp-49; 0xcbd6422dfcfp-48; 0x43f2160f545p-48; 0x713e24c4373p-51; 0xb1a2bc2ec5p-51])]);
(17%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x173c1bad920751p-53; 0xd1766d99ba585p-52; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(17%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (19%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (19%nat, 0xd1766d99ba585p-52, [0x16d64b8eb3a2fdp-90; 0x18c0542e5ea357p-84; 0xc8768df1f4425p-78; 0x1f6f844786f983p-75; 0x1b53de1bbf803bp-71; 0x8b828f1c5cd15p-66; 0x10e110ed12c593p-64; 0xc9e2c13a5e68bp-61; 0x1d61cf16acc47p-56; 0xd527029db91e5p-57; 0x12aaaafc3064f1p-56; 0x13d902dd4144c5p-55; 0x1f02459081f3b1p-55; 0x10cdfee0660f41p-54; 0x169a8b4d239eabp-55; 0x71d10a6e38609p-55; 0xe64e78b374c1p-73; 0]);
  (17%nat, 0x173c1bad920751p-56, [0x69c9c19337439p-54; 0x493273893f84bp-52; 0x158cae141fb7e5p-54; 0x1785847c354613p-55; 0x455097db30d7bp-54; 0x12a23402901879p-58; 0x1e849e49a67e07p-61; 0x9c1bd52c4087p-58; 0x13c484311ad7a1p-66; 0x7fc9658aa9279p-68; 0x149b9f31cdb703p-73; 0x151d78e18cd88fp-77; 0x87d2baed6b86bp-80; 0xa7da72c398329p-85; 0x4cfcf93aab5d5p-89; 0x18b3d9e0c119fdp-97; 0x13ce0e6ae73e7dp-103; 0x7780913ecf0f9p-109])])].

Definition rows_8 : list (nat * list float * list (nat * float * list float)) := [
(17%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(17%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (26%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (26%nat, 0x1p-1, [0x1p-8; 0x1p-5; 0x7p-6; 0x7p-5; 0x23p-7; 0x7p-5; 0x7p-6; 0x1p-5; 0x1p-8; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (26%nat, 0xfp-4, [0x1p-59; 0x7bp-58; 0x375fp-58; 0xf7e9fp-58; 0x607b33p-55; 0x6ea7c221p-58; 0xc139d2581p-58; 0x10590394cc5p-58; 0x2294f29a250fp-59; 0x7233f6f01dp-50; 0x9fe259b68fp-48; 0x2c8361b447dp-48; 0x13797abedf6bp-49; 0x346e71da80e5p-49; 0x346e71da80e5p-48; 0x49676c31e7a7p-48; 0x201d3f55d5591p-51; 0xd39383266e87p-51])]);
(18%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(18%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (18%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (18%nat, 0x5p-3, [0x17179149p-54; 0x15a618347p-53; 0x2656203231p-54; 0x154c4ac68dp-50; 0x214734d63c5p-52; 0x4da625f3e21p-51; 0x230cc676f999p-52; 0x1909200bd6dbp-50; 0x1cafca0d90dafp-53; 0x1a8fce0c8f9b5p-52; 0x4faf6a25aed1fp-53; 0xc12d205b5a3bp-50; 0x2ef3db6b897c9p-52; 0x120f059f83a61p-51; 0x157f98fad9ad5p-52; 0x26382c689f6dp-50; 0xbf18de0b1d21p-54; 0x12bc29d8eec7p-53; 0x3782dace9d9p-54])]);
(18%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x11p-6; 0xd27f1ad7501b7p-53; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(18%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (20%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (20%nat, 0xd27f1ad7501b7p-53, [0x2bf455e1d958dp-62; 0xfce409ff2f1e5p-61; 0x555629356dde9p-57; 0x11efb3d44ed2f9p-57; 0x1506fe23b01169p-56; 0x1239c950a2655p-51; 0xc154dbc740075p-54; 0xc8090abd1d835p-54; 0x519f14e7cce39p-53; 0x34b800c98f715p-53; 0x6b762611b81dfp-55; 0x5585b50ddeb1bp-56; 0x1a0e998e86543fp-60; 0x5e0da30055ba1p-60; 0x1da4df8db22ee1p-65; 0x17567a4b853561p-68; 0x453240eacd78bp-70; 0x13a741d49e7eadp-92; 0]);
  (20%nat, 0x1f05e6ef8cc3p-46, [0xfe49fe3da826bp-68; 0x1f88fc06dadd7fp-65; 0xeb142977867b3p-61; 0x11124249676edp-55; 0xdd81587d21131p-57; 0x109ef3bbee5709p-56; 0x7a4419fdc6111p-54; 0x15f7081ec0f67bp-55; 0xc78636dee84d3p-54; 0x1675254ce7e9a5p-55; 0xffdb78acb5903p-55; 0x47527d7d35379p-54; 0x1e8bb8725289b9p-58; 0x137399cee851fbp-59; 0x116585eecbf4a5p-61; 0x9c9003c6dd85fp-63; 0xa7a46fdab1eb5p-67; 0xf389e0f5a8ab5p-81; 0x7fffffffffff9p-105])]);
(18%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(18%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (27%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (27%nat, 0x1p-1, [0x1p-9; 0x9p-9; 0x9p-7; 0x15p-7; 0x3fp-8; 0x3fp-8; 0x15p-7; 0x9p-7; 0x9p-9; 0x1p-9; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (27%nat, 0x9p-4, [0x5c908960d05b1p-63; 0xa3a4176fb97c7p-60; 0x81a33dc98c4b5p-57; 0x78ef36d7654c7p-55; 0x12531d212d76c7p-55; 0x1dfc77724a6e9bp-55; 0x84cb85be867c1p-53; 0x181031505ab3cfp-55; 0x535d09f4c6f2dp-54; 0x85064cc217d3bp-57; 0x1d5dd1c8b7p-53; 0x61a24f13p-50; 0x208b6fb1p-52; 0x112a9a9p-51; 0x1c06ddp-52; 0x4455p-50; 0x1d49p-54; 0x3fp-53; 0x1p-54])]);
(19%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(19%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (19%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (19%nat, 0x7p-3, [0x1p-57; 0x85p-57; 0x20bbp-57; 0x5124fp-57; 0x238029p-55; 0x2e9835dp-55; 0x2f90b6efp-55; 0x26a594a23p-55; 0x32b95314dfp-56; 0x1b1f8aa5d3bp-56; 0xbddcca88c9dp-56; 0x43f64e50f6c9p-56; 0x9e940c123fd5p-55; 0x255b7debaf099p-55; 0x701279c30d1cbp-55; 0x105807171c942fp-55; 0xe4d06343901a9p-54; 0x8d53889aabd43p-53; 0x36f5d1917bb61p-52; 0x50fe7834b64fbp-54])]);
(19%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x79f1728edb42fp-54; 0x18c55a52b71699p-53; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(19%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (21%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (21%nat, 0x18c55a52b71699p-53, [0x177377aa75659p-87; 0xb467d76869d35p-84; 0x14799ab9dc279fp-80; 0x5d49d64e3dbb3p-74; 0x12abff4c7fc27bp-72; 0x16505b3b02d49p-65; 0x527e999f0dbd9p-64; 0x1e249f78a80a4dp-64; 0x8d3a89841474dp-60; 0x8587b76c74f1dp-58; 0x198765b0ab4d85p-58; 0x7df585350a8e1p-55; 0xf889f95c15c51p-55; 0x1826468a47b289p-55; 0x1cdbd130f74ce1p-55; 0x19738f40b0a401p-55; 0x1ed5f19edf3547p-56; 0x584a07f0eef61p-55; 0x13c49835ad761fp-60; 0]);
  (21%nat, 0xf18ab4a56e2d3p-52, [0xbb9bbd53ab2e7p-128; 0x1cc044fed4aa55p-121; 0x10ad823cae41d3p-113; 0xc2a9609922507p-106; 0xc82a51d557f8bp-100; 0x26856455a511dp-92; 0x5c0cebedc744fp-88; 0x574dcafbbd30bp-83; 0x42a8eb43a9b11p-78; 0xa535f4c42707dp-75; 0x53519d48929a9p-70; 0x1112d782744a97p-68; 0xb4cd38bd9a75dp-64; 0x17dc155eabc5a5p-62; 0x13aef441c35ab5p-59; 0x188c2170ec6525p-57; 0x2bba7fa9eac35p-52; 0x18ee5f815f4b8dp-54; 0x1813c4ee733199p-54; 0x8a8d67b5ffff7p-59])]);
(19%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(19%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (28%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (28%nat, 0x1p-1, [0x1p-10; 0x5p-9; 0x2dp-10; 0xfp-7; 0x69p-9; 0x3fp-8; 0x69p-9; 0xfp-7; 0x2dp-10; 0x5p-9; 0x1p-10; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (19%nat, 0x7p-4, [0x1p-57; 0x85p-57; 0x20bbp-57; 0x5124fp-57; 0x238029p-55; 0x2e9835dp-55; 0x2f90b6efp-55; 0x26a594a23p-55; 0x32b95314dfp-56; 0x12bb4f512f41cdp-59; 0x6c555b989a6c5p-55; 0x4860c9225799bp-53; 0x74ced187ca607p-53; 0x1f6445d12093c9p-55; 0x5db4d292a88cdp-53; 0xc44c5ac1673a7p-55; 0x8e47395d28181p-56; 0x110e3d2b821aedp-59; 0x9c33e7d35f99bp-61; 0x50fe7834b64fbp-64])]);
(20%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(20%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (20%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (20%nat, 0x1p-3, [0x8dbd525c3f0b7p-55; 0xca7c2c83c7c73p-54; 0x89668bebb5473p-53; 0xeb8b3901c90c5p-54; 0x11e047c1474213p-55; 0x105807171c942fp-56; 0xbac9759a6b2fdp-57; 0x1aaf10cceabdbp-56; 0x318e43c5b3f29p-59; 0x25c1b9bb33c5p-57; 0xbddcca88c9dp-58; 0xc5427bfbd5p-57; 0x548a3522c9p-59; 0xedd392abp-56; 0x21f9a73dp-57; 0xf8811fp-56; 0xb180cdp-60; 0x17ddbp-58; 0x122fp-59; 0x23p-58; 0x1p-60])]);
(20%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x1fp-6; 0x18edcf991221ffp-53; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(20%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (22%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (22%nat, 0x18edcf991221ffp-53, [0x17c9c80b7b17e3p-93; 0x188c5e52014dc1p-87; 0x17f761a715a79bp-82; 0x1d6ad79612a849p-78; 0x1970d29baaad5fp-74; 0x107710ed8ba4cfp-70; 0x4221d9b6e5473p-65; 0x1a5804120fde75p-65; 0x871923e6c65bp-57; 0x8c769f10e15fdp-59; 0xed8dcd63b8cfbp-58; 0x28c5f220db0d9p-54; 0x1693c8bba5ac1p-52; 0x13e9ff4cf6daa1p-55; 0x1b677384e5ce3bp-55; 0x1c71ef49202157p-55; 0x1509fda5c3dd19p-55; 0x4f9949c7199p-46; 0x24aee8e438ed1p-55; 0x329c30d1a4827p-65; 0]);
  (22%nat, 0x1c76e7cc8911p-45, [0xbe4e405bd8bdp-108; 0x1d1851f64d0603p-106; 0x86e41cda76dbfp-98; 0x6277358e143fbp-92; 0x32bf12d9a153dp-86; 0x139e0104b1727p-80; 0xbcbe9a1d503fbp-79; 0xb4a44eb14225p-71; 0x1172abf08d8eedp-72; 0x57d1993dab4ddp-67; 0xb49910379006fp-65; 0x97a24aca28d3dp-62; 0x19da745cc5975p-57; 0x1c571ce2b58f63p-59; 0xc434e2968fe81p-56; 0x823de701e82c7p-54; 0x3f332a3185bcbp-52; 0x148299bd4f3167p-54; 0x39cf44edd396dp-52; 0x1cd256787f377bp-59; 0x1000000000002dp-72])]);
(20%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(20%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (29%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (29%nat, 0x1p-1, [0x1p-11; 0xbp-11; 0x37p-11; 0xa5p-11; 0xa5p-10; 0xe7p-10; 0xe7p-10; 0xa5p-10; 0xa5p-11; 0x37p-11; 0xbp-11; 0x1p-11; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (29%nat, 0x3p-2, [0x1p-31; 0x33p-31; 0x4bfp-31; 0x4605p-31; 0x1655dp-30; 0xa6d97p-30; 0x3ac3a7p-30; 0xfd7a2dp-30; 0x68ddc35p-31; 0x107a16afp-31; 0x1e9d3503p-31; 0x2799fb91p-31; 0xf609p-19; 0x12edp-16; 0x12edp-17; 0x3c9p-16; 0x12edp-20; 0x11dp-18; 0x5fp-19; 0x5p-18; 0x1p-20])]);
(21%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(21%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (21%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (21%nat, 0x3p-3, [0x1b1ae4d6e2ef5p-63; 0x15586102d2b60fp-63; 0x4009230878223p-58; 0xf355eb86954ebp-58; 0x522032b09f30fp-55; 0x53c4ae956f2cdp-54; 0x10c0efb77ca29p-51; 0x2b14b18eae345p-52; 0x5a7841aba1077p-53; 0x139a0e3a8505e1p-55; 0x1c3a000259273p-52; 0x877cccd81255bp-55; 0x877cccd81255bp-56; 0x38478849ffbd3p-56; 0x134bb9b2f898a3p-60; 0x5671f84082abdp-60; 0x9b99f20db8021p-63; 0x1b7585117ad33p-63; 0x1d4a278a1c9dp-62; 0x2c659fa389bp-62; 0x553dff4e79p-63; 0x26f7c52b3p-63])]);
(21%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x13p-6; 0xdp-4; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(21%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (23%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (23%nat, 0xdp-4, [0x49e5041cccccdp-98; 0x31c9ff150147bp-91; 0x1fdaa559eea2d1p-89; 0x19ba601b116eebp-84; 0x75acee7f994ddp-78; 0xca77af194db0dp-75; 0x10fe634259337dp-72; 0x123c8959e460e1p-69; 0x7f07e95dbcfa7p-65; 0x16a678ef4aa85fp-64; 0x1a991bb42b717p-58; 0xcdefe77f147dp-55; 0x147abb24dc11d7p-58; 0xd4d7e99b617e9p-56; 0xdf1dd2fdb12a1p-55; 0x1726a5a90daa77p-55; 0x1d8c689d69fe23p-55; 0x373c980ff1959p-52; 0x452f1133c3dafp-53; 0x179f793bfecb77p-57; 0x1092db7b9a38adp-61; 0]);
  (23%nat, 0x37p-6, [0xb3f837cf1accbp-108; 0x15b80f945dac5p-98; 0x13eaf645f7798fp-96; 0x2e235544624a9p-88; 0x975f28658c7fp-81; 0xbae8949e615b3p-81; 0xb43b00d8ee6e1p-77; 0x115eafc7a1c29fp-74; 0x56fd2d17a69e9p-69; 0xb28f742a56e7dp-67; 0x97017d4a81481p-64; 0x34ae9c3f9e325p-60; 0x1e41b40717d87p-57; 0x71b2c3fcbaac5p-57; 0x56616cebb96b9p-55; 0xd0846478ec237p-55; 0xc2618ce834971p-54; 0x85b6403359f07p-53; 0xfa2aedd40dc1dp-54; 0x425ad57eabc9p-49; 0x19c2240db4199bp-59; 0x1p-42])]);
(21%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(21%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (30%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (30%nat, 0x1p-1, [0x1p-12; 0x3p-10; 0x21p-11; 0x37p-10; 0x1efp-12; 0x63p-9; 0xe7p-10; 0x63p-9; 0x1efp-12; 0x37p-10; 0x21p-11; 0x3p-10; 0x1p-12; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (30%nat, 0xbp-4, [0x1b1ae4d6e2ef5p-75; 0xfc13b69b3e7e7p-73; 0x222d82f3c2269p-66; 0x2dd8e524d01a3p-63; 0x54f5f76165f23p-61; 0xe5ffae5083995p-60; 0x1d4a2beb38895dp-59; 0xb641fb353c2b3p-56; 0xd8ea9da228243p-55; 0xc37b0090f1f15p-54; 0x2074b2f8234abp-51; 0x1e00f94cf8f02bp-55; 0x87357b82c481bp-54; 0x38478849ffbd3p-56; 0x134bb9b2f898a3p-60; 0x5671f84082abdp-60; 0x9b99f20db8021p-63; 0x1b7585117ad33p-63; 0x1d4a278a1c9dp-62; 0x2c659fa389bp-62; 0x553dff4e79p-63; 0x26f7c52b3p-63])]);
(22%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(22%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (22%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (22%nat, 0x5p-3, [0x74e74f819p-66; 0x85f3b5c475p-65; 0x125051d9dbffp-66; 0x32df1c40b86fp-64; 0x64aee7eac25bbp-66; 0x12e0cb7c047131p-65; 0x5925880286c13p-61; 0xa9cd955a253f3p-60; 0x42544e57368cbp-57; 0x2afdc0ffa35b3p-55; 0xba4b99a91935dp-56; 0x54ae00070b759p-54; 0x40af955ab6f9dp-53; 0x14bb8f0caa3c5fp-55; 0x2c6d571b23a5fp-52; 0x13bed161652d4fp-55; 0x39973806bc6edp-53; 0x43c0f69e83553p-54; 0x1f5e135c593f23p-58; 0x580c902ba52fp-53; 0x580c902ba52fp-55; 0x1bf3bbfd9a06cbp-64; 0x878678326eac9p-66])]);
(22%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x11b6fe01e9c67fp-58; 0x11p-6; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(22%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (24%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (24%nat, 0x11p-6, [0x197c018237916bp-62; 0xc11fd5577d98bp-58; 0x2b8c1fef0c469p-54; 0x18de90a6e4feedp-56; 0xa169861297fffp-54; 0x18ba12901a0bcdp-55; 0x17c1dee2c01421p-55; 0x1255377bbaf271p-55; 0xb8bdb595dfb3p-51; 0x2ffb8b886889p-50; 0xa58031be93edbp-57; 0x1db243c8d573d7p-60; 0x8de09eaef143p-56; 0x118fe97d7b7137p-63; 0xe50b4ef63ca25p-65; 0x97e05da2a66dbp-67; 0x5074fd7f60725p-69; 0x108fab33a496f1p-74; 0xa23719ef31d61p-77; 0x111466c28580c3p-82; 0x430805aeb9297p-85; 0x140b3485405e5bp-94; 0]);
  (23%nat, 0xb0a49f40b7aa7p-54, [0x1c6b809f24929dp-86; 0x1605302103f41dp-58; 0x1728c2bdd37915p-56; 0x5ce31ac41316dp-53; 0x1d84eb17576b21p-55; 0x1aae1fa92eec2dp-55; 0x123a826484f2d5p-55; 0x9c558bfabccafp-55; 0x21abf775e9cc1p-54; 0xbd7f2a94be411p-58; 0xdbf5e02975b03p-60; 0xd3f116e224399p-62; 0xa9f6bd3cce567p-64; 0x1c57ae4753d5bp-64; 0x1f5369959fe1abp-71; 0xe3b71e6954905p-73; 0x14ffa63f404e5dp-77; 0x18ac5192c0f9cfp-81; 0xb34697a13dddfp-84; 0x1dfad497e5aaebp-90; 0x1b0f3673d22f93p-95; 0x1af67de6fdbb4bp-101; 0x1538dff1ec5501p-109])]);
(22%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(22%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (31%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (31%nat, 0x1p-1, [0x1p-13; 0xdp-13; 0x27p-12; 0x8fp-12; 0x2cbp-13; 0x507p-13; 0x1adp-11; 0x1adp-11; 0x507p-13; 0x2cbp-13; 0x8fp-12; 0x27p-12; 0xdp-13; 0x1p-13; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (22%nat, 0x5p-4, [0x74e74f819p-66; 0x85f3b5c475p-65; 0x125051d9dbffp-66; 0x32df1c40b86fp-64; 0x64aee7eac25bbp-66; 0x12e0cb7c047131p-65; 0x5925880286c13p-61; 0xa9cd955a253f3p-60; 0x42544e57368cbp-57; 0xcb7fe46aee1d7p-55; 0x19e8c23806d22fp-55; 0xfd84479530733p-54; 0x6bc427e7ff485p-53; 0x10f4e2cba12cfbp-55; 0x104dfff39f2745p-56; 0x309d4d7208453p-55; 0x1c3057f078fd7p-56; 0xca28e70548565p-61; 0x226e24b0c3a03p-61; 0x1143b0dc73b77fp-67; 0xc08d4074221fbp-70; 0x14dbb2195ca229p-75; 0x878678326eac9p-79])]);
(23%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(23%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (23%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (23%nat, 0x3p-3, [0xa968163f0a57bp-67; 0x921cf9965f521p-63; 0x1e22c6ad6a0f53p-62; 0x7e920f3ebd739p-58; 0xbddb16de1c2d5p-57; 0xd86f8596ce33bp-56; 0xc2cac507b994fp-55; 0x11bd701d80e6b5p-55; 0x2a93737a0229bp-52; 0x2a93737a0229bp-52; 0x478713ebb1b6bp-53; 0xcae0e010e0c9bp-55; 0x1e6e8802881e3fp-57; 0x1ee662b7bd698bp-58; 0xd3e2a4ebee417p-58; 0x1311d685dfaed9p-60; 0x5b88d28298141p-60; 0x2d3a922e754f3p-61; 0x90bb6d617763dp-65; 0x16da39b112d9ddp-69; 0x2be06ec49f12fp-69; 0x3c2c7aa7408fp-69; 0x3483e8b733bp-69; 0x15eb5ee84bp-69])]);
(23%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x17p-5; 0x1b9425ae6a60dfp-53; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(23%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (25%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (24%nat, 0x17p-5, [0x80b6ae89e1341p-108; 0xc13047d44848fp-89; 0x12dc454e86de6fp-84; 0x1c3991a6c9e8d3p-80; 0xd70a5d011642dp-75; 0x92192375495b9p-71; 0x12d045648be251p-69; 0xf3f2b570c4fadp-66; 0x13e91b826f91bdp-64; 0x1548b69c26b28bp-62; 0x12d1b64b66ee51p-60; 0x1bb34369e4b95p-55; 0x44124d851cfd1p-55; 0x8b9efdacaf501p-55; 0x7720e88110f05p-54; 0x15008ae68fd585p-55; 0xc1c360ba91f81p-54; 0xb3c483453c5cdp-54; 0x105e64622e2a65p-55; 0x90496d859ec9p-51; 0x38887fad832f3p-55; 0x1c14e63e3391f7p-60; 0x1a975d1ed68507p-63; 0]);
  (24%nat, 0x62de38859f915p-51, [0x154b3ba7d4b579p-125; 0xbdfe38c0a8da3p-96; 0xcd9edb5435de7p-90; 0x35169b02fd667p-83; 0x116485b42d0dfp-77; 0x10389990c162dbp-77; 0x16e52231fd277dp-74; 0x19615caa5216ffp-71; 0x16a35d122d507fp-68; 0x841552831161bp-64; 0x9f346c0048d5bp-62; 0x13f30116cfa8a7p-61; 0x10aea472c31fe1p-59; 0xba2f8a3c39fedp-57; 0x6bff0dfe25993p-55; 0xcf020cd4e683bp-55; 0xa22a65f912163p-54; 0x3315aeb90d025p-52; 0xca1c1de98e637p-54; 0x12e51ab568b137p-55; 0xa0c7815087d67p-55; 0x1b18ea3979ee51p-58; 0x116923ad80b745p-60; 0x403252163a531p-104])]);
(23%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(23%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (32%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (32%nat, 0x1p-1, [0x1p-14; 0x7p-13; 0x5bp-14; 0x5bp-12; 0x3e9p-14; 0x3e9p-13; 0xbbbp-14; 0x1adp-11; 0xbbbp-14; 0x3e9p-13; 0x3e9p-14; 0x5bp-12; 0x5bp-14; 0x7p-13; 0x1p-14; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (32%nat, 0xfp-4, [0x1p-83; 0x15p-79; 0xd269p-83; 0x29cf7p-78; 0x17a9ab75p-83; 0x51208b6fp-79; 0xdaa65ae66dp-83; 0x76a969096dp-77; 0x34b719e957b63p-83; 0x4d7f0551a14c3p-79; 0xbdb2862feb481p-76; 0xc1d34a49e753fp-72; 0xa539e531db09p-64; 0x1d4085e674a25dp-66; 0x443eae1e756d1p-60; 0x1026ff01d73e73p-60; 0x1c443e4338ad49p-59; 0xa2f2d05655c8dp-56; 0x2f86d2192e5a9p-53; 0x15e3241fce9c3dp-55; 0xf5232e310a091p-54; 0x1ea465c6214121p-55; 0x9bff1d650662dp-54; 0xbde8a95998785p-56])]);
(24%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(24%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (24%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (24%nat, 0x1p-3, [0x14c57285ccad29p-57; 0x11cdcfe0664b47p-55; 0x3a7fab05e2651p-52; 0xf5232e310a091p-54; 0x16fb4c5498f0d9p-55; 0xd21e2797bf757p-55; 0x17c3690c972d49p-57; 0x8bab8e00dbd0bp-57; 0x15332eb26a81f7p-60; 0x56255009d14d1p-60; 0x93adadc7aff1dp-63; 0xd6ce140b2e77p-62; 0x427cbd0fa6c35p-67; 0x1188fc69670efp-68; 0x3efbb46aea55p-69; 0x2ffcba39141p-68; 0x3db2a64962fp-72; 0x84ba67e09p-69; 0xebf60e01p-70; 0x5528ae7p-69; 0xc2a621p-71; 0x152fbp-69; 0xd35p-70; 0x15p-69; 0x1p-72])]);
(24%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x25p-6; 0x2bp-6; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(24%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (26%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (25%nat, 0x25p-6, [0x646e1c247d89fp-116; 0x1f57f0acad6c6dp-80; 0x737717755da73p-73; 0xcb2110306948fp-70; 0x38c0cc1e9e69p-61; 0x5a6dba6323b47p-63; 0x1b5059b91d54f3p-63; 0x19fc12e2d7a89p-57; 0x4fcdec50430ebp-57; 0xc923d060fadp-49; 0xd2607b11c956dp-56; 0x5bfacc65e7a8fp-54; 0x10e1282c4d392bp-55; 0x5352201b7976fp-53; 0x15940e59038d41p-55; 0x12afe2aa0cf6e9p-55; 0xd6e218e3876a7p-55; 0xfd71cf9022b89p-56; 0xf13835b0f0921p-57; 0x1697b8c0fcdd49p-59; 0x19aaa14232da1p-57; 0x14c7e5dda3d17fp-63; 0x2abdc14e8a2cfp-63; 0x53eecb689a969p-68; 0]);
  (26%nat, 0x197p-9, [0x1fe1e3c37b2d5fp-105; 0x1651ff5f780655p-98; 0x3bbea3231af47p-90; 0x196bb1c0b8b47dp-88; 0x1edfad53cfcf9p-80; 0x1c7713a5ee871bp-80; 0x14b10edb2aa2a1p-76; 0x18503f765dae4dp-73; 0x5deeb8305e459p-68; 0x12dba4f04b7d7dp-67; 0xcaf8e432567c1p-64; 0xe5bebe0571c45p-62; 0x1b64092a849ea3p-61; 0xafec2edb04c2bp-58; 0x1d9bda75645d7fp-58; 0x84cc7e0ed1837p-55; 0xf5555e843e1e3p-55; 0xb7b22d6d5c5f5p-54; 0x1b3678ff98ffe5p-55; 0x1899af1fcbe601p-55; 0x7fbcfb4a43213p-54; 0x6a49557005f0dp-55; 0x155e467b8fc141p-59; 0x115ca7898294c1p-73; 0x41c21cb8e1p-72])]);
(24%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(24%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (33%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (33%nat, 0x1p-1, [0x1p-15; 0xfp-15; 0x69p-15; 0x1c7p-15; 0x555p-15; 0xbbbp-15; 0x138dp-15; 0x1923p-15; 0x1923p-15; 0x138dp-15; 0xbbbp-15; 0x555p-15; 0x1c7p-15; 0x69p-15; 0xfp-15; 0x1p-15; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (33%nat, 0x3p-2, [0x1p-39; 0x3fp-39; 0x759p-39; 0x8a27p-39; 0x72915p-39; 0x4731abp-39; 0x2259b3dp-39; 0xd2735c3p-39; 0x40ca7723p-39; 0x1023e629dp-39; 0x341519e0bp-39; 0x874f97775p-39; 0x1175865807p-39; 0x1bf394fb39p-39; 0x212f82471fp-39; 0x1aaacdb8e1p-39; 0xb38efp-24; 0xa8ffp-21; 0x8371p-22; 0x14c1p-21; 0x14c1p-23; 0xfdp-21; 0x45p-22; 0x3p-21; 0x1p-24])]);
(25%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(25%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (25%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (25%nat, 0x1p-3, [0x48b310d44c5e1p-55; 0x103a417887e747p-55; 0xde8ca674feadp-50; 0x1e77d3bdbb3f4fp-55; 0xbf837c164fd71p-54; 0xe5d0fb4df9687p-55; 0x6d6fb49f090d3p-55; 0x15379dcb3dd625p-58; 0x1b4781bc2aeec3p-60; 0x3ae381b6b613bp-59; 0x1aeba903116815p-64; 0x14fa1ff517899fp-66; 0xdfc154e0fb115p-68; 0xffb861011eef3p-71; 0x3ea017c194a31p-72; 0x68f8d75cdbe3p-72; 0x4afae2f92f59p-75; 0x5abb6d02827p-75; 0x170b075e19p-73; 0x13679a6a3p-73; 0x1a9cb683p-74; 0xe7b995p-74; 0x30269p-73; 0xe5bp-73; 0xafp-75; 0x1p-75])]);
(25%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0xa069787ade5adp-54; 0x91e4567fc0e35p-52; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(25%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (27%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (27%nat, 0x91e4567fc0e35p-52, [0x105d1d41f5a553p-81; 0x102a94a8c043fp-72; 0xf4c6de924222dp-72; 0x127435f9d58e19p-69; 0x1fda633b8e3f2dp-67; 0x14ee3d68b4610bp-64; 0xae126ad0a5423p-61; 0x4967bd8f6064bp-58; 0x331b2f36e4079p-56; 0x76eb3e63e9433p-56; 0x74904b27b0bedp-55; 0xc18a564e1b04fp-55; 0x887801b34530bp-54; 0x147178fc3e79fp-51; 0xa645dfa41467p-50; 0x11da4fe6139bb3p-55; 0xcddf3b817fbf3p-55; 0xf66ad5d47a789p-56; 0x789bef7e09fe7p-56; 0x2f36b08575b69p-56; 0x3929658c6b7b3p-58; 0x1952f0a7319efbp-63; 0x76abb83612777p-64; 0x11f20c4362b815p-69; 0x9d9e6dfff9c79p-76; 0]);
  (27%nat, 0xbb2eb60fd88e1p-52, [0x10eb7151b8747p-94; 0x1193e1f23c3045p-92; 0x11812d392297c3p-87; 0x163cb4fa42dc5bp-83; 0x143a75fe81fd79p-79; 0x1c0ba632dfaf21p-76; 0x1ec9d867163599p-73; 0xdb9aa98a371dp-65; 0x143a441365ecefp-67; 0xc7866dfec7c8fp-64; 0x19f22c2934f06bp-63; 0x2dcc3b1a77a31p-58; 0x44c9e4558d961p-57; 0xaffc00ce0f58bp-57; 0xbf75b485c1c71p-56; 0x2c21195e7fc9fp-53; 0x44870ce79602bp-53; 0x2c63083ad2be7p-52; 0xbd3cdb19481bfp-54; 0x28a91111cfabbp-52; 0xdabe3ef19d69p-51; 0x6db6d7d1d4c5p-51; 0x12d8a5ac5032d1p-58; 0x1d532197b23c65p-61; 0x1231eb68ef3ddp-61; 0x62a32b15517f9p-86])]);
(25%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 0x1p-1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(25%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (34%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (34%nat, 0x1p-1, [0x1p-16; 0x1p-12; 0xfp-13; 0x23p-12; 0x1c7p-14; 0x111p-12; 0x3e9p-13; 0x2cbp-12; 0x1923p-15; 0x2cbp-12; 0x3e9p-13; 0x111p-12; 0x1c7p-14; 0x23p-12; 0xfp-13; 0x1p-12; 0x1p-16; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (25%nat, 0x5p-4, [0xc546562aa3p-75; 0x201bc80645ddp-75; 0xa08ae81f5d51p-73; 0x80360b274530bp-73; 0x49744bb92a4e9p-69; 0x1011709081413p-64; 0xb288e2b763461p-65; 0xc9ea0c988bb3dp-63; 0xbd4b6bcf02f89p-61; 0x139e682fbadff5p-57; 0x1ce64d90bf6573p-56; 0xc33a0e624dfdfp-54; 0x1c674c2de35c0fp-55; 0x189f2b50f80305p-55; 0x211cde9ad54e7p-52; 0x11acafe5fd2267p-56; 0xf2b1c1d1b5615p-57; 0x150b548c5991b3p-59; 0x2f2cef8f2779p-54; 0xa9cf9a1a25de7p-62; 0xf23936f906c29p-65; 0x85f909c69797bp-67; 0x1bbb7c01cb85p-64; 0x10302cc4352683p-75; 0x17c80c9f7983b1p-80; 0x108b2a2c28029p-81])]);
(0%nat, [0; 0x1p-36; 1],
 [(0%nat, -1, [1]);
  (0%nat, 0, [1]);
  (0%nat, 0x1p-1074, [1]);
  (0%nat, 0x1fffffffffffffp-89, [1]);
  (1%nat, 0xe623b15e39441p-53, [1]);
  (1%nat, 0xfda9aaf0b39bdp-53, [1]);
  (1%nat, 2, [1])]);
(0%nat, [0; 0xa4f4e3035bf99p-52; 0x149e9c606b7f33p-53; 0x527a7181adfcdp-51; 1],
 [(0%nat, -1, [1]);
  (0%nat, 0x1p-1074, [1]);
  (0%nat, 0x885c7aae2db63p-53, [1]);
  (3%nat, 0x527a7181adfcdp-51, [1]);
  (3%nat, 0x59110d27204e5p-51, [1]);
  (3%nat, 0x1fffffffffffffp-53, [1]);
  (3%nat, 2, [1])]);
(0%nat, [0; 0x125562163990d5p-53; 1],
 [(0%nat, -1, [1]);
  (0%nat, -0x1p-1074, [1]);
  (0%nat, 0x1p-1074, [1]);
  (0%nat, 0xd073d699229fp-53, [1]);
  (0%nat, 0x454d010025b41p-51, [1]);
  (1%nat, 0x125562163990d5p-53, [1]);
  (1%nat, 2, [1])]);
(0%nat, [-0x14cccccccccccdp-52; 0x13d7000700b9d3p-52; 0x162ba42f3703cfp-52; 0x492268e3d8ea5p-49; 0x4cccccccccccdp-49],
 [(0%nat, -0x9333333333333p-50, [1]);
  (0%nat, 0xbede5bf5327b9p-52, [1]);
  (0%nat, 0x9eb8003805ce9p-51, [1]);
  (2%nat, 0x8b31db2446aabp-50, [1]);
  (3%nat, 0x12489a38f63a95p-51, [1]);
  (3%nat, 0x4cccccccccccdp-49, [1]);
  (3%nat, 0x6cccccccccccdp-49, [1])]);
(0%nat, [0; 0x380208b859af1p-452; 0xec684756a2f9p-450; 0x1p-400],
 [(0%nat, -1, [1]);
  (0%nat, 0x1p-1074, [1]);
  (1%nat, 0x1d8d08ead45f1fp-455, [1]);
  (2%nat, 0x6a8ac4bacd705p-452, [1]);
  (2%nat, 0x1d52151e39cf29p-453, [1]);
  (2%nat, 0x1p-400, [1]);
  (2%nat, 1, [1])]);
(0%nat, [-0xd068726bdc575p-52; 0x1fe175337280dp-48],
 [(0%nat, -0x1d068726bdc575p-52, [1]);
  (0%nat, -0x1a0d0e4d7b8aebp-53, [1]);
  (0%nat, 0x1b30fe79789377p-52, [1]);
  (0%nat, 0x1eadf7553cafd3p-52, [1]);
  (0%nat, 0x1fe175337280dp-48, [1]);
  (0%nat, 0x1fe175337280d1p-52, [1]);
  (0%nat, 0x2fe175337280dp-48, [1])]);
(1%nat, [0; 0; 0x1p-59; 0x1p-53; 0x1p-32; 0x1p-27; 1; 1],
 [(1%nat, -1, [1; 0]);
  (1%nat, 0x1fffffffffffffp-112, [0x1p-53; 0x1fffffffffffffp-53]);
  (3%nat, 0x10000000000001p-105, [1; 0x40000200001p-115]);
  (5%nat, 0x48beab12cd75dp-52, [0xb74155041ab4dp-52; 0x48beaafbe54b3p-52]);
  (5%nat, 0x1f26838f87a893p-53, [0xd97c709386fb1p-57; 0x7c9a0e3db1e41p-51]);
  (5%nat, 1, [0; 1]);
  (5%nat, 2, [0; 1])]);
(1%nat, [0; 0; 0x158a064de1bf69p-53; 0xac50326f0dfb5p-52; 0x158a064de1bf6bp-53; 1; 1],
 [(1%nat, -1, [1; 0]);
  (1%nat, 0xbbf7a7a31f84dp-53, [0x745f20aff2fa9p-52; 0x8ba0df500d057p-52]);
  (1%nat, 0xaa2ca1a58946dp-52, [0x196bff50ba89bfp-59; 0x1f9a5002bd15d9p-53]);
  (2%nat, 0x158a064de1bf69p-53, [1; 0]);
  (3%nat, 0xac50326f0dfb5p-52, [1; 0]);
  (4%nat, 0x5628193786fdbp-51, [0x1ffffffffffffdp-53; 0x1878e35936f7e9p-104]);
  (4%nat, 2, [0; 1])]);
(1%nat, [0; 0; 0xad3bf7c68cb73p-54; 0x1720cd30861a05p-53; 1; 1],
 [(1%nat, -1, [1; 0]);
  (1%nat, 0x1p-1074, [1; 0x3p-1073]);
  (2%nat, 0x277de46b410d9p-51, [0x17f1c9dcdaaf39p-53; 0x101c6c464aa18dp-54]);
  (2%nat, 0x78255d61643f7p-52, [0x1d4cbe6368718bp-54; 0x8acd06725e39dp-52]);
  (3%nat, 0x1720cd30861a05p-53, [1; 0]);
  (3%nat, 0x1fffffffffffffp-53, [0x1cdaf1aac82e61p-104; 0x7ffffffffffffp-51]);
  (3%nat, 2, [0; 1])]);
(1%nat, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x156e3f69813adfp-53; 0x14024177e9619p-51; 0x8eeb9ce144f63p-52; 0xe5104a0474be3p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49],
 [(1%nat, -0x9333333333333p-50, [1; 0]);
  (1%nat, -0x14cccccccccccdp-52, [1; 0]);
  (1%nat, -0xab71fb4c09d7p-48, [0x196293314db80dp-105; 0x1fffffffffffffp-53]);
  (4%nat, 0xba9610f1e3c05p-52, [0x1f8efc7a8ebef3p-54; 0x81c40e15c5043p-52]);
  (5%nat, 0x1ca209408e97c7p-53, [1; 0x154264a1720ee9p-106]);
  (5%nat, 0x86ad2cfe43bb5p-50, [0x1924d4d07a2bd9p-55; 0xcdb6565f0ba85p-52]);
  (5%nat, 0x6cccccccccccdp-49, [0; 1])]);
(1%nat, [0; 0; 0x41c34515804f9p-451; 0x127d4b8969c0b3p-453; 0x1e7a9ce363ccdp-449; 0x1p-400; 0x1p-400],
 [(1%nat, -1, [1; 0]);
  (2%nat, 0x93ea5c4b4e059p-452, [0x1f3d1ba3ddf66dp-102; 0x1ffffffffffffp-49]);
  (3%nat, 0x9be3cedea0b25p-452, [0x755bb0f75ac97p-51; 0x15489e114a6d21p-56]);
  (3%nat, 0x17573f0c05d89dp-453, [0x261a78ca6f635p-50; 0x19e58735909cafp-54]);
  (4%nat, 0x1e7a9ce363ccdp-449, [1; 0]);
  (4%nat, 0x10000000000001p-452, [0; 1]);
  (4%nat, 1, [0; 1])]);
(1%nat, [-0x109b9793e6667p-50; -0x30dc351bdd305p-52; 0xc89da11b6c209p-52; 0x6905aeaf463b3p-51; 0xe2dcaa3e07db9p-52; 0x184c81998e07p-44; 0x18fb526269355dp-52],
 [(1%nat, -0x509b9793e6667p-50, [1; 0]);
  (1%nat, -0x186e1a8dee9829p-55, [1; 0]);
  (1%nat, 0x19130d3895e77bp-53, [0x156909a7272c2dp-66; 0x1fff54b7b2c6c7p-53]);
  (4%nat, 0xe2dcaa3e07db9p-52, [1; 0]);
  (4%nat, 0x1c5b9547c0fb73p-53, [0xfffffffffffffp-52; 0x3297ce22fa2e9p-102]);
  (4%nat, 0x14be4848c8bac5p-52, [0x167c5e50752d1p-50; 0x2983a1af8ad2fp-50]);
  (4%nat, 0xa3ed4989a4d57p-50, [0; 1])]);
(2%nat, [0; 0; 0; 0x1p-60; 1; 1; 1],
 [(2%nat, -1, [1; 0; 0]);
  (2%nat, 0x1fffffffffffffp-113, [0x1p-106; 1; 0xfffffffffffffp-112]);
  (3%nat, 0x10000000000001p-112, [1; 0x8000000000001p-111; 0x1p-224]);
  (3%nat, 0x350bdcd58989p-47, [0xaf90693cd21a1p-53; 0x1f1008db41f07bp-54; 0x15fbd3fa479885p-55]);
  (3%nat, 0x1a06f9bd6d5a59p-53, [0x8eb1ef1d8bbbdp-56; 0x136e89915e38bdp-54; 0xa95abac8ae615p-52]);
  (3%nat, 1, [0; 0; 1]);
  (3%nat, 2, [0; 0; 1])]);
(2%nat, [0; 0; 0; 0x80fd92bc983c5p-54; 0xaa95dd25b0f23p-54; 0x914c2e9e3a62dp-52; 0x17a3d974f69a63p-53; 0x17a3d974f69a63p-53; 1; 1; 1],
 [(2%nat, -1, [1; 0; 0]);
  (2%nat, -0x1p-1074, [1; 0; 0]);
  (2%nat, 0x380ee4b306c3p-49, [0x8c30cd14b3b25p-57; 0x1a57ffbb0d72dp-50; 0x923e7aab24973p-52]);
  (4%nat, 0x1552bba4b61e47p-55, [0x1d0e78ca9ff8b9p-53; 0x5e30e6ac00e91p-54; 0x116f4ad762b449p-160]);
  (4%nat, 0x7fc63a11316d1p-53, [0x248d30623e6e7p-50; 0xcc39749bb4381p-53; 0x7ae84292c2a33p-56]);
  (5%nat, 0x914c2e9e3a62dp-52, [0x992eb0427910dp-53; 0xb368a7dec3779p-52; 0]);
  (7%nat, 2, [0; 0; 1])]);
(2%nat, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x15c5820c099c61p-53; -0x13bdfdd34d735fp-53; -0x5b0f2dd18ee3bp-52; -0x39d7ba97c4f61p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49],
 [(2%nat, -0x9333333333333p-50, [1; 0; 0]);
  (3%nat, -0x15c5820c099c61p-53, [0x17c4994b00b117p-56; 0x1d076cd69fe9ddp-53; 0]);
  (4%nat, -0x9defee9a6b9afp-52, [0x19bfcfabce851bp-53; 0xc8060a862f5cbp-54; 0x4e521a0cd15b9p-153]);
  (6%nat, -0x35db3fc090365p-52, [0x1e21f97e1c1eadp-53; 0x1ddbcc44bf1cf7p-57; 0x126f65fbe12425p-67]);
  (6%nat, 0x1192d7d8440933p-52, [0xefc19d1506c8fp-54; 0x82f3c115f7ff7p-52; 0x1046f5e9319397p-54]);
  (6%nat, 0x13333333333333p-51, [0x11b043cbbf3837p-157; 0x185f45406d5dafp-104; 0x1ffffffffffffdp-53]);
  (6%nat, 0x6cccccccccccdp-49, [0; 0; 1])])].

Definition rows_9 : list (nat * list float * list (nat * float * list float)) := [
(2%nat, [0; 0; 0; 0x3a773241833a9p-453; 0x7f1a354f2921dp-452; 0x1p-400; 0x1p-400; 0x1p-400],
 [(2%nat, -1, [1; 0; 0]);
  (3%nat, 0xc08d602113efp-450, [0x80525f9bde457p-52; 0x1ee38e7be8c71fp-54; 0x83ecce8fd3c25p-57]);
  (3%nat, 0xd782a732f4fd7p-453, [0x1ed0238a549fe1p-58; 0x16259e38469ee1p-53; 0x11c7c156cd783fp-54]);
  (4%nat, 0x7f1a354f2921dp-452, [0x2460e4aad3507p-50; 0x1b9f1b552caf9p-50; 0]);
  (4%nat, 0x1fc68d53ca4875p-454, [0x2460e4aad3507p-50; 0x1b9f1b552caf93p-54; 0x1f8e4d2fcc754dp-159]);
  (4%nat, 0x1fffffffffffffp-453, [0x8f7e8ceebee65p-156; 0xfe379df0735abp-103; 0x7ffffffffffffp-51]);
  (4%nat, 1, [0; 0; 1])]);
(2%nat, [-0x17e3abbc6695fbp-53; -0x8a297c9f5a429p-53; -0x5f47af94f207p-52; 0xb7407d2d12983p-51; 0x7dcbcaecd85e5p-50; 0x7e6f77a82aa2bp-50],
 [(2%nat, -0xdf8eaef19a57fp-51, [0x1b5ccb932ef8c9p-53; 0x94668d9a20e7p-50; 0]);
  (2%nat, -0x17d1ebe53c81c1p-58, [0x1b5ccb932ef8c9p-53; 0x94668d9a20e7p-50; 0]);
  (2%nat, -0x5f47af94f207p-52, [0x1b5ccb932ef8c9p-53; 0x94668d9a20e7p-50; 0]);
  (2%nat, 0x184c489b695485p-55, [0x13ef2fb5f52a93p-53; 0x172085c737ce31p-54; 0x1011accdddcaa9p-58]);
  (2%nat, 0x105c817b2c1aa5p-52, [0x114e07347eb723p-56; 0x8decdb855360bp-52; 0x183147518b7a09p-54]);
  (2%nat, 0x16e80fa5a25307p-52, [0; 0x112e596e5d8c1fp-54; 0x1768d348d139f1p-53]);
  (2%nat, 0xbe6f77a82aa2bp-50, [0; 0x112e596e5d8c1fp-54; 0x1768d348d139f1p-53])]);
(3%nat, [0; 0; 0; 0; 0x1p-28; 1; 1; 1; 1],
 [(3%nat, -1, [1; 0; 0; 0]);
  (4%nat, 0xda73d6a2dc667p-53, [0x607e2d5472af1p-53; 0x1aed95a7dc528dp-54; 0xa05099b9d14dfp-53; 0x4f891765b2dd3p-54]);
  (4%nat, 0xd50e00870f273p-52, [0x13563fd6599713p-60; 0x11fcb9cd24b819p-56; 0x164f17b7c7cd6dp-54; 0x24e460d5959e3p-50]);
  (4%nat, 0x1fffffffffffffp-53, [0x10000001p-187; 0x30000003p-134; 0x180000017fffffp-104; 0x1fffffffffffffp-53]);
  (4%nat, 1, [0; 0; 0; 1]);
  (4%nat, 0x10000000000001p-52, [0; 0; 0; 1]);
  (4%nat, 2, [0; 0; 0; 1])]);
(3%nat, [0; 0; 0; 0; 0x1e6d528ce48d6fp-54; 0x1e6d528ce48d7p-50; 0x1e6d528ce48d71p-54; 0xf36a9467246b9p-53; 1; 1; 1; 1],
 [(3%nat, -1, [1; 0; 0; 0]);
  (3%nat, 0x1e19152f3266bp-53, [0xac4bce226581bp-52; 0x123b842be7153p-50; 0x149479b7869c9dp-57; 0x1ef9148eb6d093p-62]);
  (3%nat, 0x4c7170840599p-48, [0x695b276279195p-55; 0x42b8b9a23995p-48; 0x3856dfd16bcddp-51; 0x7edc439d3f587p-53]);
  (7%nat, 0xf36a9467246b9p-53, [0x7ffffffffffffp-51; 0x16e0243ad029c5p-104; 0x7449705712ae1p-157; 0]);
  (7%nat, 0x1fffffffffffffp-53, [0xddad5d3c3b789p-208; 0x15cdc5105380a5p-155; 0xb70121d6814e3p-102; 0xffffffffffffdp-52]);
  (7%nat, 1, [0; 0; 0; 1]);
  (7%nat, 2, [0; 0; 0; 1])]);
(3%nat, [0; 0; 0; 0; 0x199d19e9c07687p-53; 0x199d19e9c07687p-53; 1; 1; 1; 1],
 [(3%nat, -1, [1; 0; 0; 0]);
  (3%nat, -0x1p-1074, [1; 0; 0; 0]);
  (3%nat, 0, [1; 0; 0; 0]);
  (3%nat, 0x9883b3af9b1bfp-53, [0xfd6f3a4dd4d93p-54; 0x1c2a9714b8c01bp-54; 0x8ad4417be8d13p-53; 0xa8fb45bb360adp-56]);
  (5%nat, 0x333a33d380ed1p-50, [0x198b9858fe25d9p-55; 0x199d19e9c0768bp-53; 0x12d494b79a5203p-152; 0x1f7381e6ee50ffp-205]);
  (5%nat, 0x1d598223c1d4d3p-53, [0x74db30144c31dp-57; 0x5c064f5d92a83p-52; 0x3689642d235d9p-51; 0x19a00763c21d93p-55]);
  (5%nat, 2, [0; 0; 0; 1])]);
(3%nat, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; 0x7acbf6cc2d8fp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49],
 [(3%nat, -0x9333333333333p-50, [1; 0; 0; 0]);
  (3%nat, -0xa666666666667p-51, [1; 0; 0; 0]);
  (3%nat, -0x5333333333333p-50, [0x7ffffffffffffp-51; 0xf9608208dbb47p-103; 0x10d98c3ede6999p-157; 0x1849ba02fb67c7p-213]);
  (4%nat, 0x7acbf6cc2d8fp-49, [0xae84861b472fbp-53; 0x1f19bc802434cbp-54; 0x58ad95e39729fp-53; 0]);
  (4%nat, 0xc64fbaf4d7173p-52, [0x1295b44e9be0fp-51; 0xe7ad308b5752dp-53; 0x18c6db46d2fec3p-54; 0xf8a48074266dp-54]);
  (4%nat, 0x1d8d1a05e16dd7p-52, [0x176dffc652d58bp-60; 0x17f411461d3a37p-56; 0xfa53a3f5f5187p-53; 0xd2d6798506189p-53]);
  (4%nat, 0x6cccccccccccdp-49, [0; 0; 0; 1])]);
(3%nat, [0; 0; 0; 0; 0x57d116b4fc877p-453; 0x123fbd09d7e9b7p-453; 0x1a38a3f0dedp-441; 0x3d94b40734dd7p-450; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400],
 [(3%nat, -1, [1; 0; 0; 0]);
  (3%nat, 0x1329281830a43p-453, [0x1e954d306ba3a5p-54; 0xf76c0fb216697p-53; 0x1393d0a24d0217p-57; 0x2adb141fbba19p-60]);
  (4%nat, 0x669bce56341d9p-453, [0x18f8b86cc2dd53p-54; 0x10516a523f1ee1p-53; 0x198a0f52cae647p-56; 0x1ef1a0c2b585afp-66]);
  (6%nat, 0x1eca5a039a6eb7p-453, [0xb4ccfef93ee27p-206; 0x96d3b188f59cdp-57; 0x16cf491af0b443p-54; 0x140187c0feb041p-53]);
  (7%nat, 0x1eca5a039a6eb9p-453, [0x12da76311eb33dp-58; 0x5b3d246bc2d05p-52; 0x140187c0feb05bp-53; 0x12152c3c5b8dbp-193]);
  (7%nat, 0x1p-400, [0; 0; 0; 1]);
  (7%nat, 1, [0; 0; 0; 1])]);
(3%nat, [-0x19c9c7b207d535p-53; -0x196a6651b4db2bp-53; -0x122545c9a26599p-53; -0x29b55aa1a7aabp-51; 0x8d5dc5df01dbfp-51; 0x52f2dacc08697p-50; 0xbff971a04673bp-51; 0x6a9f0c531ed81p-50],
 [(3%nat, -0xe7271ec81f54dp-51, [0xa5046a6458b23p-52; 0xac667a79d24dp-49; 0x4c8585ebe275p-52; 0]);
  (3%nat, -0x4ccac696999c5p-52, [0x1387156e5c2313p-53; 0xba96502340a45p-53; 0x19ef9f544814f7p-58; 0x22533648027ffp-67]);
  (3%nat, -0x13bfcd4068ff1p-53, [0x150e01c0b76ccfp-54; 0x108a6475c59a95p-53; 0x4c0bf00350643p-53; 0x2ddba9a9a8bffp-57]);
  (3%nat, 0x11abb8bbe03b7dp-52, [0x1c331e20a8fcbp-207; 0x18e47fc2c56edfp-59; 0x1301cb011f9013p-54; 0x161b888065223bp-53]);
  (3%nat, 0x8d5dc5df01dbfp-51, [0; 0x31c8ff858add9p-56; 0x980e5808fc807p-53; 0x161b888065223dp-53]);
  (3%nat, 0x11abb8bbe03b7fp-52, [0; 0x31c8ff858add9p-56; 0x980e5808fc807p-53; 0x161b888065223dp-53]);
  (3%nat, 0xaa9f0c531ed81p-50, [0; 0x31c8ff858add9p-56; 0x980e5808fc807p-53; 0x161b888065223dp-53])]);
(4%nat, [0; 0; 0; 0; 0; 0x1p-51; 0x1p-36; 1; 1; 1; 1; 1],
 [(4%nat, -1, [1; 0; 0; 0; 0]);
  (5%nat, 0x1p-51, [0x1fff40017fffp-45; 0x17ffd0001ffffdp-66; 0xbfff7ffffffffp-116; 0x1p-117; 0]);
  (5%nat, 0x1fffffffffffffp-89, [0x200040008001p-257; 0x1ffffffffa0005p-53; 0xbfff7fffe8003p-86; 0x2fffa0003d001p-120; 0x1fff40017fff09p-161]);
  (6%nat, 0x6d123dd10eeabp-53, [0x188c3ead58cf71p-54; 0xd4a3ddbf2bb1dp-53; 0x1595d791ef39edp-55; 0x1f29ba879ae357p-58; 0x437c52a0de52dp-59]);
  (6%nat, 0x56548b318ae01p-51, [0xb804f9797c719p-58; 0x17d3f1542ff215p-56; 0x25064548a9d7bp-51; 0x66466dbce6b3fp-52; 0xd3e409debee37p-54]);
  (6%nat, 0x10000000000001p-52, [0; 0; 0; 0; 1]);
  (6%nat, 2, [0; 0; 0; 0; 1])]);
(4%nat, [0; 0; 0; 0; 0; 0x2dd47ad230c5p-46; 0x16ea3d69186281p-53; 0x16ea3d69186281p-53; 1; 1; 1; 1; 1],
 [(4%nat, -1, [1; 0; 0; 0; 0]);
  (4%nat, 0x1p-1074, [1; 0x1p-1072; 0; 0; 0]);
  (4%nat, 0xad6cd4220d67p-51, [0x4d5f5416e5a9p-47; 0x14c0ceaae13773p-54; 0x42cc4a2d8d44fp-54; 0xc0eea74e80cabp-59; 0x92d4caf7d79e5p-64]);
  (4%nat, 0x16ea3d6918627fp-53, [0xf3638431a5581p-262; 0xa3656552fb2a7p-205; 0x424dcd529bd7fp-151; 0x48ae14b73cec3p-52; 0xb751eb48c313dp-52]);
  (7%nat, 0x5cdc0b10a57afp-51, [0x7f18ca347f51p-49; 0x17db391308aab9p-53; 0x32140cd388a4fp-57; 0x123bf7b067490dp-65; 0x13eb0688f6457fp-72]);
  (7%nat, 1, [0; 0; 0; 0; 1]);
  (7%nat, 2, [0; 0; 0; 0; 1])]);
(4%nat, [0; 0; 0; 0; 0; 0x1ddae00ba91ffp-51; 0x1ddae00ba91ffp-51; 1; 1; 1; 1; 1],
 [(4%nat, -1, [1; 0; 0; 0; 0]);
  (4%nat, 0x1ddae00ba91fefp-55, [0x151e34f17450fp-260; 0x13b3d19ea2eabdp-209; 0x9681c7654c87p-48; 0x16e43c41b09c91p-54; 0x1bda8f27e20d77p-57]);
  (6%nat, 0x1ddae00ba91ffp-51, [0x9681c7654c87p-48; 0x16e43c41b09c91p-54; 0xded4793f106bdp-56; 0; 0]);
  (6%nat, 0x82b588178f14dp-53, [0x10bdacd08b848fp-53; 0xcc54b1f34371dp-53; 0x13e2271c172c51p-56; 0x60decf71d2923p-64; 0xb78f3d92aa051p-72]);
  (6%nat, 0x8181e85aea8e1p-52, [0xcfa41d9bf9c3fp-55; 0x5a811ce0c52f9p-52; 0x1a71e5c5e25395p-54; 0x1dab0f790655e9p-56; 0x417b8db2bf3bbp-56]);
  (6%nat, 0x10000000000001p-52, [0; 0; 0; 0; 1]);
  (6%nat, 2, [0; 0; 0; 0; 1])]);
(4%nat, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x1c7afe1bad419p-51; -0xa7b58e8e9a77p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49],
 [(4%nat, -0x9333333333333p-50, [1; 0; 0; 0; 0]);
  (4%nat, -0x5333333333333p-50, [0xffffffffffffdp-52; 0xed9677bfb7331p-102; 0x8d870332fe0a3p-153; 0x660071022819dp-207; 0xdc8b5535186f3p-264]);
  (4%nat, -0x1c7afe1bad4191p-55, [0x17bd8505310c81p-273; 0x62420497d4981p-59; 0x112056711f3b87p-53; 0xc748bea798d31p-53; 0x2528d23414225p-53]);
  (5%nat, -0x1d0224de90eafp-52, [0x13d7cc2940ca8bp-66; 0x7487d67dcf581p-52; 0xe048ba951cd71p-53; 0x1b4bfe05e81c1fp-56; 0x16c1f57e810fd1p-67]);
  (6%nat, 0x1a2a4deabba93p-51, [0x10f8876f7672e5p-54; 0xf64c5d776a51p-49; 0x1f5c6bbe1c4b43p-55; 0x4705678597165p-57; 0x1ac3382ef2c625p-66]);
  (6%nat, 0x4cccccccccccdp-49, [0; 0; 0; 0; 1]);
  (6%nat, 0x6cccccccccccdp-49, [0; 0; 0; 0; 1])]);
(4%nat, [0; 0; 0; 0; 0; 0x64e0fff25b75p-447; 0x1a831ef4800485p-453; 0x1bb7a6b3f705e1p-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400],
 [(4%nat, -1, [1; 0; 0; 0; 0]);
  (4%nat, -0x1p-1074, [1; 0; 0; 0; 0]);
  (4%nat, 0x96605d99055abp-452, [0x113aa3e5674551p-60; 0x1f239a9d23b52bp-57; 0x880c4b04cbb7bp-53; 0xeae0ecfef0545p-53; 0xd78fb1c4e6ac3p-54]);
  (6%nat, 0x1a831ef4800485p-453, [0x77938b08bb3e7p-61; 0x15e4ea67c413f3p-55; 0x19e54356459767p-53; 0x9a08d718d7e75p-57; 0]);
  (7%nat, 0xed192dac18e69p-452, [0x190829d3f0929dp-60; 0xdbfb9c5fc45a7p-54; 0x1c662c43807d7dp-54; 0x12e034e21fccafp-54; 0xa5711b44eb787p-56]);
  (7%nat, 0x10000000000001p-452, [0; 0; 0; 0; 1]);
  (7%nat, 1, [0; 0; 0; 0; 1])]);
(4%nat, [-0xeb12dfa18732fp-52; -0xc6baacade39a3p-52; -0xbbb7ffd452ce7p-52; -0xdbc2861cc84c7p-53; -0x37ed3d6d15aa9p-53; 0xa37ab991b943dp-51; 0x5d4c176f2c903p-50; 0xc83fcb388c781p-51; 0x1c979cb0176cc5p-52; 0x7b344d10ea1e9p-50],
 [(4%nat, -0x1eb12dfa18732fp-52, [0x306b85d6b5ec3p-51; 0x7946f66da91cfp-52; 0x2493827cab499p-52; 0x14e7b683fc11e5p-60; 0]);
  (4%nat, -0x1bf69eb68ad549p-56, [0x306b85d6b5ec3p-51; 0x7946f66da91cfp-52; 0x2493827cab499p-52; 0x14e7b683fc11e5p-60; 0]);
  (4%nat, -0x1bf69eb68ad547p-56, [0x306b85d6b5ec3p-51; 0x7946f66da91cfp-52; 0x2493827cab499p-52; 0x14e7b683fc11e5p-60; 0x12907bb929f7a7p-279]);
  (4%nat, 0x124edc19963ebp-54, [0x41eb05f3ced09p-52; 0x1f4499d36d5211p-54; 0x1e0b3882617d03p-55; 0x9d34d0568a3a5p-57; 0x13d9b824db727bp-67]);
  (4%nat, 0x338e677c72f19p-54, [0x1db067a1f94a0dp-55; 0x7bf7d175e31dbp-52; 0x8468d32b70b81p-53; 0x66ccbb4ffcc39p-56; 0x18a7edc897e17bp-66]);
  (4%nat, 0xa37ab991b943dp-51, [0; 0x1dc94815ad095dp-63; 0x181293e1d8841p-53; 0xd51b59dd511dfp-53; 0x1125aed207fa9fp-53]);
  (4%nat, 0xbb344d10ea1e9p-50, [0; 0x1dc94815ad095dp-63; 0x181293e1d8841p-53; 0xd51b59dd511dfp-53; 0x1125aed207fa9fp-53])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x15161352f9dcd1p-54; 1; 1; 1; 1; 1; 1],
 [(5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (5%nat, 0x4b4521319b501p-52, [0x1e3cbc4fab4e61p-69; 0x42f2b9a3e180fp-52; 0x1aa1c6a3dfa1f9p-54; 0xff28dca6475a3p-54; 0x882f5bc28a21dp-55; 0x1b51744da5f10dp-60]);
  (5%nat, 0x15161352f9dcdp-50, [0x1019362ade3e9dp-314; 0xceff8c51035d3p-54; 0x196d8517cea2e7p-54; 0x12bdcdfd0d98ddp-54; 0x311d22f284d83p-53; 0xc10fc7c2f362fp-58]);
  (6%nat, 0x15161352f9dcd1p-54, [0x677fc62881ae9p-53; 0x196d8517cea2e9p-54; 0x95ee6fe86cc7p-49; 0x188e9179426c1dp-56; 0x6087e3e179b19p-57; 0]);
  (6%nat, 0xe8c2d21a2fec9p-52, [0x13479657e1b309p-69; 0xef0318c1f0befp-63; 0x24dbc18ba5c79p-56; 0x2d080f875b2b9p-53; 0x1ad748ece5b951p-54; 0x1eeca7740d8ad7p-54]);
  (6%nat, 0x10000000000001p-52, [0; 0; 0; 0; 0; 1]);
  (6%nat, 2, [0; 0; 0; 0; 0; 1])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 1; 1; 1; 1; 1; 1],
 [(5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (5%nat, -0x1p-1074, [1; 0; 0; 0; 0; 0]);
  (5%nat, 0, [1; 0; 0; 0; 0; 0]);
  (5%nat, 0x1p-1074, [1; 0xfp-1073; 0; 0; 0; 0]);
  (11%nat, 0xc96fa75f71533p-52, [0x12866bb6182bc5p-58; 0xb57999cdeadd5p-54; 0x8f973520aa651p-52; 0xbf1caf512de39p-54; 0xd2d727d6683dbp-56; 0x2e8565945b7d1p-57]);
  (11%nat, 0x1d9e8b992ea49fp-53, [0x18924fc7476f1p-62; 0x8c4275671653dp-59; 0x98992906ee4d1p-55; 0xf141c560525e9p-54; 0xcfcc637d062e9p-53; 0x8f2f1c939511dp-53]);
  (11%nat, 2, [0; 0; 0; 0; 0; 1])]);
(5%nat, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x21ffea554823fp-49; -0x1d753f0456a1fp-52; 0x12e7af9dbf08bp-51; 0xb2d885b76b8dp-50; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49],
 [(5%nat, -0x9333333333333p-50, [1; 0; 0; 0; 0; 0]);
  (6%nat, -0xe3514f88cae55p-52, [0x12e6a41ec40d87p-55; 0x1af711229c28d9p-54; 0xa1d4f2e0ff1d1p-53; 0x1c16f0526a459bp-56; 0x15469b142c7313p-60; 0x9fc3daa636a19p-68]);
  (6%nat, -0x101f01832e1405p-53, [0x4dd9bd6c95ecbp-58; 0x186fbd9bccaacbp-56; 0x12ef146be853adp-54; 0x1036a66a8007c1p-53; 0x605628e4a76e7p-54; 0x1a398636b2a67fp-61]);
  (7%nat, -0x1d753f0456a1fp-52, [0x1545ac891d92bbp-62; 0xd60d077136765p-57; 0x126fd15c426521p-53; 0x167f9008563cf5p-54; 0xb7db60ee5b929p-56; 0]);
  (8%nat, 0x12e7af9dbf08b1p-55, [0x16bcf1bec98f49p-73; 0xb7c14769400f9p-53; 0x7dbfda0e664f5p-52; 0x130dd73b408591p-55; 0x10f219ffef9047p-62; 0x17101b7d7557a1p-327]);
  (8%nat, 0x165b10b6ed719fp-55, [0x17cb8a78194d4bp-322; 0xad04bea94dca7p-53; 0x3f813c84c678dp-51; 0x15065a8bf81b55p-55; 0x6e7231b499767p-60; 0x1609d64062ba33p-78]);
  (9%nat, 0x6cccccccccccdp-49, [0; 0; 0; 0; 0; 1])]);
(5%nat, [0; 0; 0; 0; 0; 0; 0x3c0592ea96dfbp-451; 0x6392decfade31p-451; 0x6f0df86b02d35p-451; 0x1c84c9922bf16fp-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400],
 [(5%nat, -1, [1; 0; 0; 0; 0; 0]);
  (5%nat, 0x27564c632ffdp-447, [0x13e8d065568725p-60; 0x188a8c3fa8125p-51; 0xd08e02bce784fp-53; 0x4b146bfa07a07p-52; 0x2fa7f6447d921p-53; 0x13e78ffd0237dp-55]);
  (6%nat, 0x1e02c9754b6fd9p-454, [0x197dc7055df67p-54; 0x186375e6b610e3p-55; 0xc527a94200933p-53; 0x28d8f8986647dp-51; 0xa49ee4fb7c3b9p-55; 0x884d5f05cd8b3p-315]);
  (6%nat, 0x8aa67226a6999p-452, [0xd56b0ccab93f5p-59; 0x60f42e9d6397dp-54; 0x1416b7bfe8ff9p-50; 0xd6f74d66c9c15p-53; 0x151c44b0a30fedp-55; 0x121e5585518125p-65]);
  (6%nat, 0x18e4b7b3eb78c3p-453, [0x11ac87095dde91p-314; 0x104a37e1be8c95p-64; 0xbb3438471e8a5p-58; 0xc86cfa80efcb3p-54; 0x99c1df7fb80d3p-52; 0x1892e36386e3b1p-55]);
  (7%nat, 0x6392decfade31p-451, [0x104a37e1be8c77p-64; 0x17668708e3d12fp-59; 0xc86cfa80efcadp-54; 0x4ce0efbfdc069p-51; 0xc4971b1c371ddp-54; 0]);
  (9%nat, 1, [0; 0; 0; 0; 0; 1])]);
(5%nat, [-0xe91c1c60882d9p-52; -0xe8d5bfeb22badp-52; -0x1527dd303cb017p-53; -0xd9edfad6d173bp-53; -0x3f289a91aac8fp-52; -0x2e15fbf703cb9p-52; 0xb88eaec535255p-53; 0x10a82668a78c3p-48; 0x4bf4bde288ac7p-50; 0x9d1c4d863f667p-51; 0x19439c75c978ddp-52; 0xe5783c5d8ddd3p-51; 0x7ddcbe3a744b5p-50],
 [(5%nat, -0x1e91c1c60882d9p-52, [0x11a3b28f04c2d5p-55; 0x9efe7223438f3p-52; 0x3af394009688fp-52; 0x162e5f20384431p-59; 0x191b42ab358aa9p-69; 0]);
  (5%nat, -0x170afdfb81e5c9p-55, [0x11a3b28f04c2d5p-55; 0x9efe7223438f3p-52; 0x3af394009688fp-52; 0x162e5f20384431p-59; 0x191b42ab358aa9p-69; 0]);
  (5%nat, -0x743db3e9d5aa3p-55, [0x26ae1159ec05bp-54; 0xfa226c815a41dp-53; 0x340d1285a0017p-51; 0x215821707fa53p-53; 0xf873bc5f1e465p-61; 0x1ab8e50f22f579p-69]);
  (6%nat, 0xb88eaec535255p-53, [0x6fee1bd6b6d1dp-55; 0x1474e7e034591bp-54; 0x1afacdfba0ab77p-54; 0xbbe79f5245d5p-50; 0x1525f5050e78a1p-58; 0]);
  (6%nat, 0x1711d5d8a6a4abp-54, [0x1bfb86f5adb473p-57; 0xa3a73f01a2c8dp-53; 0x35f59bf74156fp-51; 0x5df3cfa922ea9p-53; 0xa92fa82873c53p-57; 0x12cd5566f7cdc7p-322]);
  (6%nat, 0x910843b0202ebp-52, [0x938820ca5ff07p-58; 0x411662bb444ffp-53; 0xbe9d73be259bfp-53; 0xc71d31994ae7fp-53; 0xd165eb9ed6287p-55; 0xe4effd0a8a54dp-63]);
  (6%nat, 0xbddcbe3a744b5p-50, [0; 0x16a973f4465efbp-65; 0x1369739564f995p-59; 0x3ac3f5de55ac3p-52; 0x12dab7f4ec4f19p-53; 0x15f6e3a6d08c51p-55])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x1p-15; 0x1p-14; 0x1p-5; 0x1p-1; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (6%nat, 0x1p-1074, [1; 0x3p-1058; 0; 0; 0; 0; 0]);
  (7%nat, 0x1p-15, [0x1p-5; 0x1ee787bee01p-41; 0x1877c5330eefp-53; 0x1efb14467p-55; 0x8ff7p-53; 0x1p-55; 0]);
  (8%nat, 0x1fffffffffffffp-58, [0x40301c0f07c3fp-368; 0xb96da10c5ee05p-52; 0x840f3455897b1p-53; 0x119550ab09d389p-58; 0x126b3da16a5fdbp-63; 0x4c929e6a14591p-67; 0x1fb3488b1aa8cbp-77]);
  (9%nat, 0x224fea48d1bc1p-51, [0x15c4beb66a221p-55; 0x12f5115db3cb51p-54; 0xc842aea945785p-53; 0xe6c54626c8a0fp-54; 0x110c686c5abd9dp-56; 0x13b954b4ebb0dfp-59; 0xe73688b3b28c3p-63]);
  (10%nat, 0x6f0c13a122793p-51, [0x175f05cb0cf71bp-69; 0xdf9a51d08d6ebp-63; 0xdc9734f95b0efp-59; 0x1c81e3ddefd773p-57; 0x200119e35702fp-51; 0x43c088771f97p-47; 0x1432f657dfe01bp-55]);
  (10%nat, 2, [0; 0; 0; 0; 0; 0; 1])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x1722bc799e48dp-51; 0x1722bc799e48dp-51; 0x1722bc799e48dp-51; 1; 1; 1; 1; 1; 1; 1],
 [(6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (6%nat, 0x2c599845bf021p-52, [0xb025ec166d667p-79; 0x17d2d12d5950bdp-73; 0xabd7d20e4b82bp-66; 0x129563769a5ce7p-53; 0x1621ad5c938b17p-54; 0x119f688014623fp-56; 0x12c0afa14fcc7p-56]);
  (9%nat, 0xc6b5a1c4c9383p-52, [0x1df1b6977b76bbp-65; 0x96d5d4e5bedddp-59; 0x9c3e66ab976fdp-56; 0x2a2bb78764a39p-52; 0x13fe0cea14f223p-54; 0x2a8e749679fd1p-51; 0x12df5059c173adp-55]);
  (9%nat, 0x1fffffffffffffp-53, [0x746499b8349c9p-368; 0xae96e6944eeadp-313; 0x1b4794072c54bp-256; 0x122fb804c83875p-206; 0xb2ca81fc1d2adp-153; 0xea5c28eb28d41p-102; 1]);
  (9%nat, 0x10000000000001p-52, [0; 0; 0; 0; 0; 0; 1]);
  (9%nat, 2, [0; 0; 0; 0; 0; 0; 1])]);
(6%nat, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; 0x1bd5f4edce16f5p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49],
 [(6%nat, -0x9333333333333p-50, [1; 0; 0; 0; 0; 0; 0]);
  (6%nat, -0x5333333333333p-50, [1; 0x1f94e9f38bbc4bp-104; 0xaab63cb5c2e51p-155; 0xf6123738bcad5p-209; 0xc78464202a475p-263; 0x1591c5a29cc971p-319; 0xf8ba7cf24e435p-375]);
  (6%nat, 0x1531259e9b3343p-52, [0x6d036e856e6edp-68; 0x1b64600ed1c7dp-57; 0x11752547752b15p-57; 0x251b7d4a995c3p-52; 0xa14d7a7fe4da1p-53; 0xb1ee558f02c87p-53; 0x13d83c032994b7p-55]);
  (6%nat, 0x6f57d3b7385bdp-50, [0x14c4bc6e8aa661p-374; 0x17b7fce1ca3b5p-61; 0x110fdc609fabd9p-60; 0x2746697550065p-54; 0x169a14eccf337p-51; 0xd01c19f3dc127p-53; 0xbf9eaa15495cdp-53]);
  (7%nat, 0x1bd5f4edce16f5p-52, [0xbdbfe70e51da1p-64; 0x110fdc609fabd3p-60; 0x4e8cd2eaa00c9p-55; 0xb4d0a766799b7p-54; 0x1a03833e7b825p-50; 0xbf9eaa15495dp-49; 0]);
  (7%nat, 0x1c9d14c8cda139p-52, [0x1dfae189923ca5p-66; 0x1811d650cc3661p-61; 0x1eeee4c8c949b9p-58; 0x9f17b84f538f7p-54; 0x66553e630499p-48; 0x1a58428ff050f7p-54; 0x15625135ad4b7bp-75]);
  (7%nat, 0x6cccccccccccdp-49, [0; 0; 0; 0; 0; 0; 1])]);
(6%nat, [0; 0; 0; 0; 0; 0; 0; 0x12229768ba56dp-451; 0x96444148154bdp-453; 0x1c99ac0cd3b3cbp-453; 0x1d22aa76e3f8bdp-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400],
 [(6%nat, -1, [1; 0; 0; 0; 0; 0; 0]);
  (6%nat, 0, [1; 0; 0; 0; 0; 0; 0]);
  (7%nat, 0x12c8882902a979p-454, [0x17a2348f79e7c5p-365; 0x29930e20d867p-48; 0x5f509f3b523c7p-52; 0x54593e6235c37p-52; 0x7913729e3d665p-54; 0x8df878b9bd017p-57; 0x1ce7a884af1fd1p-65]);
  (8%nat, 0x19b930ceb054c1p-453, [0x1ec047ad75c41fp-72; 0x13171a178f612dp-65; 0x41fa1ccc8eddfp-57; 0x4b78af5134b8fp-54; 0x1297d39606b1b5p-54; 0x1be88a8c41f9fbp-54; 0xc41b81bb60dbdp-54]);
  (9%nat, 0x741d9d58d8e3bp-451, [0xff73a88c3c41fp-94; 0xe8f0843493325p-65; 0x11f3c99935f025p-60; 0x83c9352b8adcdp-55; 0x5a38372a5c7f1p-52; 0x942671ec7d1dfp-52; 0x1ac25ffc3e51d1p-68]);
  (10%nat, 0xe91553b71fc5fp-452, [0x5d8fda772534bp-64; 0x7a651dacac8d3p-59; 0xeead6db4ae15fp-56; 0x15c410aab0e0efp-54; 0x2640fb89cd01bp-50; 0x65519bcc8b833p-64; 0xed368273cb321p-349]);
  (10%nat, 1, [0; 0; 0; 0; 0; 0; 1])]);
(6%nat, [-0x1df051a5458debp-53; -0x1af2821bce469bp-53; -0x17eacfe8e38e8dp-53; -0x913ea2ceccdcfp-52; -0xaa18e7b02c49bp-53; -0x92028788d35edp-53; -0x12bf15e369597p-53; 0x5b371d53219c1p-53; 0x2ad660acafa25p-49; 0xb2a6a3cd6172bp-51; 0x5d03069816413p-50; 0x18a97b9ce0f8e1p-52; 0x18c9cf44801cdp-48; 0x1cee9a4edc3f6dp-52; 0xecf728789be4bp-51],
 [(6%nat, -0xf7c146951637bp-51, [0xb3e1091759465p-60; 0x18d1dec9c5982dp-54; 0xed8021b338a3bp-53; 0x8bca865f2cdc5p-54; 0x909d646a5461bp-58; 0x1ef79982d7187p-61; 0]);
  (6%nat, -0x12bf15e369596fp-57, [0xb3e1091759465p-60; 0x63477b271660bp-52; 0x3b60086cce28fp-51; 0x117950cbe59b8bp-55; 0x1213ac8d4a8c37p-59; 0xf7bccc16b8c39p-64; 0x144950574380e1p-395]);
  (6%nat, 0x16cdc754c86703p-55, [0x1bf7f887953a5dp-378; 0x9147b794f1357p-54; 0x1a7700b158084fp-54; 0x16088cfd5b8061p-54; 0x174051793b8ac1p-56; 0x135bb111741dc3p-59; 0x104f122e057b73p-66]);
  (7%nat, 0x5b371d53219c1p-53, [0x9147b794f1357p-54; 0x1a7700b158084fp-54; 0x16088cfd5b8061p-54; 0x174051793b8ac1p-56; 0x135bb111741dc5p-59; 0x104f122e057b77p-66; 0]);
  (7%nat, 0x21bb0144eff99p-49, [0x102d5e2e30c6c1p-67; 0x1aee907339794dp-62; 0x1a2446ef65584dp-58; 0x9d7b390fa2f5dp-54; 0xc09a95cf1f87bp-53; 0x17135e2820b583p-54; 0xa87ce454c5343p-55]);
  (7%nat, 0x9f7de3488235p-47, [0x276ae92806093p-74; 0x9ac2a58b8a919p-67; 0x2cb8875a67613p-59; 0x3dadc29a2e929p-55; 0xc895ac3f60e6fp-54; 0x80a34e96bd709p-52; 0x8a4dcda8f1f1dp-53]);
  (7%nat, 0x16cf728789be4bp-51, [0; 0x4135cfc9b7c41p-74; 0xeb8ee099bbb61p-66; 0x16d77af41f3361p-60; 0x5447a167dd553p-54; 0xef24ad20b0e53p-53; 0x1c7aa6898527b7p-54])]);
(7%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0x1p-44; 0x1p-22; 0x1p-3; 0x1p-1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(7%nat, -1, [1; 0; 0; 0; 0; 0; 0; 0]);
  (7%nat, 0x1fffffffffffffp-97, [0x1p-371; 0xffffe80000fp-44; 0x17ffff0fffe6ffp-72; 0x1dffff5fffe8ddp-112; 0x9ffffe1fffb07p-153; 0x77ffff3fffdc7p-197; 0x17ffffeffffcbbp-244; 0x1ffffffffffff9p-291]);
  (10%nat, 0x4010e908dd1d7p-53, [0x16b9f8de4ef955p-55; 0x4551f81765a1p-47; 0x1d312f257ac293p-55; 0xc14199699d9f7p-56; 0xae435a0c09995p-59; 0x149e91c75b7fddp-64; 0x101da4ffaf43d3p-69; 0x118157b9cd6939p-140]);
  (10%nat, 0x212a9d1fbb41dp-51, [0x839a228e2fd25p-58; 0x4396abbf0cacbp-52; 0x61b3ce897b775p-52; 0x1f6d6cf50f9e8dp-55; 0xac792b852fbabp-55; 0x1f681ed71ea885p-59; 0x4fcc2ccc0cc4fp-60; 0x26e56503301a9p-67]);
  (11%nat, 0x1p-1, [0x124924db6db925p-58; 0xd634417829dfbp-55; 0x817e2384d9f65p-53; 0x2916ec9fd3a51p-51; 0x1c6a704dbd2da5p-55; 0x9a7a6576af0dbp-55; 0x196164dbad37b7p-60; 0]);
  (11%nat, 0x10000000000001p-53, [0x924926db6dc8fp-57; 0x1ac6882f053befp-56; 0x205f88e1367d9p-51; 0x2916ec9fd3a51p-51; 0xe353826de96d5p-54; 0x134f4caed5e1bdp-56; 0x196164dbad37c5p-60; 0x1p-364]);
  (11%nat, 2, [0; 0; 0; 0; 0; 0; 0; 1])]);
(7%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0x1cbac16e419c13p-54; 0x72eb05b906705p-52; 1; 1; 1; 1; 1; 1; 1; 1],
 [(7%nat, -1, [1; 0; 0; 0; 0; 0; 0; 0]);
  (7%nat, 0x1p-1074, [1; 0x7p-1073; 0; 0; 0; 0; 0; 0]);
  (7%nat, 0x5aeb84a1d63fdp-53, [0x1e2cae5d02e63dp-58; 0x1147cc7a61ea3bp-55; 0x1fbd281399f639p-54; 0x424f2e1f632cbp-52; 0x470666ed13f4bp-54; 0x153e01c94920ebp-59; 0x3643768df7241p-60; 0x1cf9b345408f77p-68]);
  (7%nat, 0x289b5fb803af5p-51, [0x18778a8310aa7fp-65; 0xce58588a05b01p-60; 0x715aa8f554029p-53; 0xc02d88094efd9p-53; 0x118aa290f8fd39p-54; 0x6a7d737a6f525p-54; 0x14b8fd4bc761f5p-58; 0xd259dae29fff3p-61]);
  (8%nat, 0x1cbac16e419c13p-54, [0x1e8d806acbb7bbp-370; 0x1a06f607e28807p-57; 0xd401090a1fbe1p-54; 0xacb0021094b3dp-53; 0x8ca98eadeef13p-53; 0x3949c2fc777a5p-53; 0x12aa637024f2d1p-58; 0]);
  (9%nat, 0x1fffffffffffffp-53, [0x34ae6e2085065p-419; 0xb8628171d1961p-365; 0x11493c22aba611p-311; 0x1ccf6439c8bf7p-254; 0xe67b21ce45fb7p-204; 0x8a49e1155d307p-151; 0x19675750479af3p-102; 0x7fffffffffffdp-51]);
  (9%nat, 2, [0; 0; 0; 0; 0; 0; 0; 1])]);
(7%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0xb3660b195902dp-53; 0xb3660b195902dp-53; 0xb3660b195902dp-53; 0xb3660b195902dp-53; 0xb3660b195902dp-53; 0xb3660b195902dp-53; 0x15eca59a5284bbp-53; 0x15eca59a5284bbp-53; 0x1b02c14898caa3p-53; 0x1b02c14898caa3p-53; 0x1b02c14898caa3p-53; 0x1b02c14898caa3p-53; 0x1b02c14898caa3p-53; 0x1b02c14898caa3p-53; 1; 1; 1; 1; 1; 1; 1; 1],
 [(7%nat, -1, [1; 0; 0; 0; 0; 0; 0; 0]);
  (7%nat, 0x56427411eedb9p-52, [0x430934b7c9b43p-83; 0xb7dea543fa569p-77; 0x1b047d5cb31dbfp-72; 0x11a4e1ed46fabp-62; 0xdd3c111f53895p-61; 0x34033ab04eab7p-55; 0x9579e85091935p-52; 0x18e4a36dd9b683p-54]);
  (7%nat, 0x166cc1632b2059p-54, [0x1819056644e22bp-420; 0x1d8d6d21b63113p-365; 0x1f10806815e63fp-311; 0x122419c1456dabp-257; 0x196cf25b7efbd3p-205; 0xab0c9953e4875p-152; 0x3e8a091c12a91p-51; 0x105d7db8fb55bdp-53]);
  (13%nat, 0x138fa933a0b4bfp-53, [0xd08051fc22893p-68; 0x1509af1b3619a7p-63; 0x187a997c8de5ddp-57; 0x17e9e9874f0725p-55; 0x147ba4cc7cd493p-54; 0x497ab202acea1p-52; 0x87c7f55293085p-54; 0x3345ce5a6cc09p-55]);
  (21%nat, 0x1b02c14898caa3p-53, [0x1fb108efa7b8bdp-54; 0x10277b882c23a1p-53; 0; 0; 0; 0; 0; 0]);
  (21%nat, 0x6c0b0522632a9p-51, [0x1fb108efa7b891p-54; 0x204ef71058477p-50; 0x35fdfee2618f7p-146; 0x120945170e0f91p-198; 0xe75c890a9af1bp-248; 0x1bd2c1434b5c59p-300; 0x1dbdfe47562eb5p-352; 0x1b4061846f8e07p-405]);
  (21%nat, 2, [0; 0; 0; 0; 0; 0; 0; 1])]);
(7%nat, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x7ceb35d717eb7p-52; 0x930da9d0bbe03p-50; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49],
 [(7%nat, -0x9333333333333p-50, [1; 0; 0; 0; 0; 0; 0; 0]);
  (7%nat, -0x14cccccccccccdp-52, [1; 0; 0; 0; 0; 0; 0; 0]);
  (8%nat, -0x1f3acd75c5fadbp-54, [0x6e548afc4c8bfp-53; 0x189cd04ba95c6bp-54; 0x11769f582bbf1dp-54; 0x1a4f8c5f96e381p-56; 0x164199c384289dp-58; 0xa08100232f075p-60; 0xf1043d45e61edp-65; 0x14467fb2d0208fp-441]);
  (8%nat, 0x4be8a8ebbfb49p-51, [0x71741b93659e9p-58; 0xe7b9e1b794fcdp-56; 0xb3d2e2c402787p-54; 0x4aab148da9141p-52; 0x478ffb4ec456bp-52; 0x9a1515de1cf73p-54; 0x270e419a76f97p-54; 0x117cc2a98531cdp-62]);
  (8%nat, 0x1a1d64ce88c5f9p-52, [0x141413603846dbp-69; 0xdd1ded8c9fecfp-63; 0x2ce8c648e3347p-57; 0x2592ca8923eefp-54; 0x122db91196839p-51; 0x146e80f9ada4dfp-54; 0x18208605a1c59bp-54; 0x7a00d2b2e28f1p-54]);
  (8%nat, 0x1261b53a177c05p-51, [0x15b2bd043a7249p-422; 0x13a7b51b2a5b1fp-83; 0x8171f99dbb1fp-70; 0x163056cfb4ead3p-69; 0x1036905180ec11p-63; 0xd4d863da494b1p-58; 0x172d467e097a05p-55; 0xce30f0c8ed8a3p-52]);
  (9%nat, 0x6cccccccccccdp-49, [0; 0; 0; 0; 0; 0; 0; 1])]);
(7%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0x4fd242098f18fp-452; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400],
 [(7%nat, -1, [1; 0; 0; 0; 0; 0; 0; 0]);
  (7%nat, 0x13f4908263c63bp-454, [0x1b445a771659d9p-419; 0xd9935d1ceb1cdp-55; 0x24f7659d8b513p-51; 0x53bdeb23a9a59p-52; 0xca5a0b54551efp-54; 0x8984f2cc3daddp-55; 0xc761022383f37p-58; 0x78718cee8e41fp-61]);
  (8%nat, 0xbe443bca9249bp-453, [0xe6442f28304a9p-56; 0xd439611dc9697p-54; 0x51a8a4a581201p-52; 0x10cb9717b73dcdp-54; 0xf95e714b79effp-55; 0xf79c432fd99efp-57; 0x19b65bbbae4495p-61; 0x5070864c9a471p-75]);
  (8%nat, 0x1670e856ce1b49p-453, [0x1436096c06aa23p-64; 0x50bedd4bc44dfp-58; 0x22439cd530f39p-54; 0x7f7d2e7346a0dp-54; 0x8afdc4dc2f6e1p-53; 0x15afab50566697p-54; 0x1a9c2fd26ba3fbp-55; 0x130ab16bf9a6cdp-58]);
  (8%nat, 0x1p-400, [0; 0; 0; 0; 0; 0; 0; 1]);
  (8%nat, 0x10000000000001p-452, [0; 0; 0; 0; 0; 0; 0; 1]);
  (8%nat, 1, [0; 0; 0; 0; 0; 0; 0; 1])]);
(7%nat, [-0x1e54ecb60517f3p-53; -0xd2df953b03db5p-52; -0x190944883bb4c1p-53; -0x17fb1f564b014bp-53; -0x6e341c68f90e5p-52; -0xdb876367dbfe3p-53; -0x3e0416a6f7a7dp-52; -0x51c2327c6db1p-51; 0x1306c808570337p-53; 0x1b669f507e33a5p-53; 0x1cb0fba66ca6d5p-53; 0x214d7c4e18c11p-49; 0x95181b18b5231p-51; 0xac8aa87624c4bp-51; 0xc1ed593d87065p-51; 0x6b9fee83261b9p-50; 0x1b7975b346215p-48; 0xdd6d3cafe8b2bp-51; 0x7ecc5368b9249p-50],
 [(7%nat, -0xf953b2d8145fdp-51, [0xe7ff8930ab8b9p-57; 0xee02db49c5689p-54; 0x1a1c249a492bbp-50; 0x11e864f3e90149p-54; 0x1820a22df7fb53p-57; 0x11b569b33f5b01p-60; 0x17ef910a238cdbp-68; 0]);
  (7%nat, -0x14708c9f1b6c41p-57, [0xe7ff8930ab8b9p-57; 0xee02db49c5689p-54; 0x1a1c249a492bbp-50; 0x11e864f3e90149p-54; 0x1820a22df7fb53p-57; 0x11b569b33f5b01p-60; 0x17ef910a238cdbp-68; 0]);
  (7%nat, 0x67864722703e5p-55, [0x278483356b09bp-56; 0x227dfbf61f865p-52; 0x169ab739f1eb47p-54; 0xbf4fa242437fbp-53; 0x1c99acfa390c3p-52; 0x11260ac7da843dp-58; 0x13dd930b16059fp-64; 0x8e6598daebfe5p-76]);
  (8%nat, 0x1834743e493d8fp-53, [0x5ef2c95657df9p-74; 0x19d38c207d6f15p-68; 0x800e305bede09p-59; 0x1137c5234ae7dp-52; 0x15e97aaaf018a7p-54; 0xe6efbabf3b43p-49; 0x114e1390be75p-47; 0x1921352a4216f5p-65]);
  (9%nat, 0x1b669f507e33a5p-53, [0x9e777c85ba469p-79; 0xd61b222446a55p-64; 0x1d13e5ded422abp-59; 0xbdcc0a52dd1f7p-54; 0xffb39f102cec1p-53; 0x972fb57faa91bp-53; 0x16b74a19140f8dp-60; 0]);
  (9%nat, 0xdb34fa83f19d3p-52, [0x13ceef90b74867p-80; 0x1ac3644488d48bp-65; 0xe89f2ef6a114dp-58; 0x2f730294b747dp-52; 0x1ff673e2059d7fp-54; 0x972fb57faa91dp-53; 0xb5ba50c8a07cfp-59; 0x1d95cee28c84abp-413]);
  (10%nat, 0xbecc5368b9249p-50, [0; 0x1e09af002901bp-64; 0xc76d8ef5af819p-58; 0x1a203e8f046d81p-55; 0x12b2e3f918b38dp-53; 0x1858ed4eff786bp-55; 0x1242b906de2431p-59; 0x1d350720253c35p-65])]);
(8%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0x1p-49; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(8%nat, -1, [1; 0; 0; 0; 0; 0; 0; 0; 0]);
  (9%nat, 0x1c7bd79ecec99p-50, [0x126bb2fe33f6d1p-59; 0x1d8be9251421b7p-57; 0x2977d96f8c661p-52; 0x10a0ea6f19185fp-54; 0x10ab84a30c7eadp-54; 0x1564072af89c3fp-55; 0x449eeef5a8c25p-54; 0xfb94cb5f08167p-58; 0x1938852d492611p-62]);
  (9%nat, 0xb34dec629fcfdp-52, [0x11035cc3df66d3p-66; 0x9f1916932bd9dp-61; 0x14574e85ed6d89p-59; 0xbe38079ace1a3p-56; 0x8af88fe26d113p-54; 0x103eab55e070c1p-54; 0x97e9b76fbb7e1p-53; 0x195e38e27b2b85p-55; 0x1da7530c538affp-57]);
  (9%nat, 0x1fffffffffffffp-53, [0x2000000000001p-473; 0x2000000000001p-417; 0x1c00000000000dp-366; 0x7000000000003p-310; 0x8c00000000003p-257; 0x3800000000001p-203; 0x3800000000001p-151; 0x8000000000003p-101; 0x1fffffffffffffp-53]);
  (9%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (9%nat, 0x10000000000001p-52, [0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (9%nat, 2, [0; 0; 0; 0; 0; 0; 0; 0; 1])]);
(8%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0x178a10e7b3b661p-53; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(8%nat, -1, [1; 0; 0; 0; 0; 0; 0; 0; 0]);
  (8%nat, 0x1p-1074, [1; 0x1p-1071; 0; 0; 0; 0; 0; 0; 0]);
  (8%nat, 0xe052700815cabp-53, [0x2edfb04a6a6d5p-60; 0x11d9c43269b90dp-57; 0x8ca96c6480bb7p-54; 0x107a0d0b3096a5p-54; 0x8fff43890bdf3p-53; 0xc25eb2e41cd73p-54; 0xa09f072bd3ea1p-55; 0x4ad8917fb639bp-56; 0x1e3d9d66ca54e1p-62]);
  (8%nat, 0xbc50873d9db3p-48, [0xba9fd91bbaeb1p-472; 0x17ad50506703a1p-66; 0x1cd1e9942930cfp-62; 0x1e1190f8d05fc5p-59; 0x8b6da4551ec2bp-55; 0xc1f5767d45c75p-54; 0x143c794d13861p-50; 0x12c460046759bbp-54; 0x3bac46ed40d85p-53]);
  (9%nat, 0x178a10e7b3b661p-53, [0x17ad505067038bp-66; 0xe68f4ca14985dp-61; 0x1e1190f8d05fb5p-59; 0x116db48aa3d85p-52; 0xc1f5767d45c73p-54; 0x143c794d138611p-54; 0x962300233acdfp-53; 0xeeb11bb503619p-55; 0]);
  (9%nat, 0x1d1f68d54d474bp-53, [0x1159f3d20a1fafp-78; 0xa99679303f207p-71; 0x1675a3955c047dp-67; 0x35af1464cb2abp-60; 0x9d2a999f88f01p-58; 0x8e360f420271fp-55; 0x962992e60812dp-53; 0x12e83def3d3d59p-53; 0x126a8f068a5bb5p-57]);
  (9%nat, 2, [0; 0; 0; 0; 0; 0; 0; 0; 1])]);
(8%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0x1901356beb8dedp-55; 0x1901356beb8dedp-55; 0x1901356beb8dedp-55; 0x1901356beb8dedp-55; 0x1901356beb8dedp-55; 0x1901356beb8dedp-55; 0x1901356beb8dedp-55; 0xa4ef43d98238bp-53; 0xa4ef43d98238bp-53; 0xa4ef43d98238bp-53; 0xa4ef43d98238bp-53; 0xa4ef43d98238bp-53; 0xa4ef43d98238bp-53; 0xa4ef43d98238bp-53; 0x34ef559652af3p-50; 0x34ef559652af3p-50; 0x34ef559652af3p-50; 0x34ef559652af3p-50; 0x1a7a5ccd2d8a13p-53; 0x1a7a5ccd2d8a13p-53; 0x1a7a5ccd2d8a13p-53; 0x1a7a5ccd2d8a13p-53; 0x1a7a5ccd2d8a13p-53; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(8%nat, -1, [1; 0; 0; 0; 0; 0; 0; 0; 0]);
  (8%nat, 0x1p-1074, [1; 0x5p-1071; 0; 0; 0; 0; 0; 0; 0]);
  (22%nat, 0x8742cece0a6ddp-52, [0x1890b68ca9026fp-59; 0x15fc7cb4c2da81p-56; 0x19a0fa991836d5p-55; 0x46c454bbbdbbp-48; 0xf4578b7ef637fp-54; 0x436e2fa6d5a11p-53; 0xba0ea9be06719p-56; 0x12554ad6d0fc09p-59; 0x1949f0eb7bb675p-63]);
  (26%nat, 0xd3d2e6696c509p-52, [0x1299ca4b759e2fp-426; 0x259882535f015p-368; 0x427d634c0c6fp-311; 0x10cc71b2a6eaa5p-264; 0x15388626d0a8c7p-212; 0x1fd151dada49f5p-53; 0x5d2ec72f3f8f3p-58; 0x5af76b6c12719p-67; 0x766768276d40dp-78]);
  (31%nat, 0x1eb6b724c26513p-53, [0x121286759eabe1p-69; 0x1dd1e241019c87p-65; 0x158639d7e000cdp-61; 0x470355be895f9p-56; 0x1243a5c22560e5p-56; 0x180ede8687f6b7p-55; 0x9e73036956fd9p-53; 0x12a2951e0514d7p-54; 0x1eaee6540f1bb5p-56]);
  (31%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (31%nat, 2, [0; 0; 0; 0; 0; 0; 0; 0; 1])]);
(8%nat, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x9c701f61604afp-51; 0xf0d9b41cae5ddp-52; 0x10597daf336cabp-52; 0x1ca6d42f207ee3p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49],
 [(8%nat, -0x9333333333333p-50, [1; 0; 0; 0; 0; 0; 0; 0; 0]);
  (8%nat, -0x138e03ec2c095fp-52, [0x16237b6273e12bp-439; 0xc7e1f9899f1d1p-52; 0x19447956f546d5p-55; 0x155f88d6330e8dp-58; 0x3bdfbf0077c85p-60; 0x535d8ced33309p-66; 0x455b05fccf521p-72; 0x1ffad7362cec2fp-82; 0x64f72cf6a265bp-88]);
  (9%nat, -0x9c701f61604afp-51, [0x31f87e6267c73p-50; 0x19447956f546e3p-55; 0xaafc46b198757p-57; 0x77bf7e00ef91dp-61; 0x14d7633b4ccc6fp-68; 0x455b05fccf535p-72; 0xffd6b9b167671p-81; 0x64f72cf6a2685p-88; 0]);
  (9%nat, -0x18073857f92f33p-53, [0x1bfc2f60ab1099p-56; 0x9508eb3961bbp-49; 0x1788dd822140efp-54; 0x17536b2ad3062dp-55; 0xaffd2e14aeaf7p-56; 0x191d4ec4879203p-60; 0x43cff0d705503p-61; 0xbd32031840831p-67; 0x11e9cfaa161dedp-74]);
  (9%nat, -0x8eefb5b2d99ebp-52, [0x55285b3648261p-55; 0xb14cfb8ba3cd9p-54; 0xbb59ebd76a7e9p-53; 0x9416becfc47e1p-53; 0xd600c5fa6873p-51; 0x1716e7bc84288fp-58; 0x1792e282d80df3p-61; 0xcb13e7d732359p-64; 0x4561b43d6ea01p-68]);
  (10%nat, 0x1e1b368395cbbbp-53, [0x47b4e1ada0a31p-84; 0x8086d001ffa61p-62; 0xb208bed2f7969p-57; 0x39f7dc70c5505p-53; 0x223478ae563a7p-51; 0x15482723cf68cfp-54; 0xd95a225d612ebp-54; 0x1ae72732f60515p-57; 0x3023b48061121p-473]);
  (12%nat, 0x6cccccccccccdp-49, [0; 0; 0; 0; 0; 0; 0; 0; 1])]);
(8%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0x8073a2b5454d9p-453; 0x12be5dcb079905p-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400],
 [(8%nat, -1, [1; 0; 0; 0; 0; 0; 0; 0; 0]);
  (8%nat, 0x100e7456a8a9b1p-454, [0xf8e2de904911fp-468; 0x146f6fbf1beca7p-58; 0x115eae531aa821p-54; 0xbb1bc17705193p-53; 0xf1ab924c7f87fp-54; 0xb10ded849ad1p-51; 0x9751cd8166c45p-57; 0x46acbd518a321p-59; 0x1bff77a944cf21p-66]);
  (9%nat, 0xfb4b5a9ae0bb5p-453, [0x1bef696c0c3e29p-73; 0x3ba32cfc40d87p-56; 0xb1d20c3ab80fp-51; 0xe15eaa6e4d971p-54; 0x9bcc22005fd8bp-53; 0xf9656df5f1735p-54; 0x1bc7157aee8b59p-56; 0x1674559f0db097p-58; 0x40eed4fa50a9fp-62]);
  (10%nat, 0x95f2ee583cc83p-452, [0x16e572901bb1cfp-61; 0x1b5e5937791ef3p-58; 0xddfbc5958b0fbp-55; 0xf5fc73637a335p-54; 0x4f7ef991dd62dp-52; 0x1d251d4b2d2fbfp-55; 0x147fc48c5cab05p-56; 0x74d7eebe3f48fp-59; 0x901d80dccff21p-465]);
  (10%nat, 0x6d878091f2e49p-451, [0x1454296212d9abp-73; 0x1d069f2bd25835p-68; 0x47cd59ed288dbp-61; 0x18ffc06dad4f99p-60; 0xaa014653e54c3p-56; 0x162e40ef4229bdp-55; 0x6a3480de710ddp-52; 0x54c5be84a15cdp-52; 0x10a6da22a42b2bp-57]);
  (10%nat, 0x1p-400, [0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (10%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 1])]);
(8%nat, [-0x1c8a1fa4624929p-53; -0x1c38c20db9072dp-53; -0x16e91554c1fc23p-53; -0x9de2e8d97219bp-52; -0xe8d0216d07937p-53; -0x40b339bf93bc1p-52; -0x7a559a11a4cf7p-53; -0x3144767f3a287p-52; -0x8f957ca6f4c1p-52; 0x1241e6cf840633p-53; 0x400dd700fdbfbp-50; 0x917be9a133f3bp-51; 0x53eb8b3b7f529p-50; 0xadac3cbc23447p-51; 0xc00c2c25fac97p-51; 0x6031af2d6b08dp-50; 0xc3a269e52dd35p-51; 0xc94a3ecce33ddp-51; 0x3f2712f698f83p-49],
 [(8%nat, -0x79143f48c4925p-50, [0x69cc3c315aadfp-56; 0x914e559ee3807p-53; 0x37d5bf356d5c7p-51; 0x1c2e08b72e9d9p-51; 0x85d453f34782fp-56; 0x151de1a28d77adp-62; 0x57fb05a9b3b1p-61; 0x13d95294bfc911p-74; 0]);
  (8%nat, 0xa7cc4b0a542e7p-53, [0x90b72d9d53f9p-63; 0x3358c5f6ca37fp-56; 0x3b064ee719957p-53; 0x1576ccab3e2e35p-54; 0x2c0bd537bc427p-51; 0x1392d1177ace6dp-55; 0x1280655db60f23p-57; 0x1d335caacb94a5p-61; 0x1eeef898c250e5p-67]);
  (8%nat, 0x2182adfb7040dp-50, [0x1282a210107b23p-87; 0xd31c8137d02dbp-62; 0x14be733d979413p-58; 0x935fe15fd78dfp-54; 0x14bc1782b85235p-54; 0x51e7f00e33a03p-52; 0x13e29656459c35p-55; 0x1157cb06b50185p-57; 0xf486de6d37f6fp-61]);
  (9%nat, 0x1241e6cf840633p-53, [0x2e1a700c895d7p-61; 0xc004ea46a8f2fp-58; 0x360f61f1611d1p-53; 0x49a3fa584c5dp-48; 0xaf83ba788ffbfp-53; 0xc9c100e89a495p-54; 0xd21f1506d1c33p-56; 0x1d24a0e0cfee7dp-61; 0]);
  (9%nat, 0x49079b3e1018dp-51, [0x5c34e01912babp-62; 0x18009d48d51e55p-59; 0x6c1ec3e2c23a1p-54; 0x49a3fa584c5dp-48; 0xaf83ba788ffbfp-53; 0xc9c100e89a497p-54; 0x690f8a8368e1bp-55; 0x1d24a0e0cfee87p-61; 0x8788c5a429d93p-472]);
  (9%nat, 0x100375c03f6febp-52, [0x4c9c60f5ac9bdp-468; 0x610a0cf8aea19p-73; 0x2031b1a8af301p-61; 0xdd0766151a809p-59; 0x4b30086f8e52fp-54; 0x42add8ba9bb8dp-52; 0x3519f7845b295p-51; 0x1dfdc5b89aae5fp-55; 0x146400123075c5p-59]);
  (9%nat, 0x5f2712f698f83p-49, [0; 0xc21419f15d405p-74; 0x1018d8d45797efp-64; 0x6e83b30a8d3fdp-58; 0x12cc021be394b1p-56; 0x10ab762ea6ee31p-54; 0x1a8cfbc22d94abp-54; 0x1dfdc5b89aae6dp-55; 0x146400123075ddp-59])]);
(9%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x1p-50; 0x1p-46; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(9%nat, -1, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (9%nat, -0x1p-1074, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (11%nat, 0x187901a9a19dbp-50, [0x1ac74c352e3be1p-59; 0x9537177933fc1p-55; 0x2e312a8447ce5p-52; 0x8576529bb414bp-53; 0xf7e487ece8c87p-54; 0x132f510687c3p-47; 0x1facb16f02d17p-53; 0x10cf2af55f45e7p-58; 0xa683c196064f1p-60; 0x16e8f2b1cf86d7p-65]);
  (11%nat, 0x8e903fc01fbfdp-52, [0x2b29582b2a717p-60; 0xf4191d37a5357p-59; 0x132c65c4703d6bp-57; 0xe0e6b8cdf5975p-55; 0x69fe4a3444659p-53; 0x85358673f1405p-53; 0xdf37a33f38957p-54; 0xf074db646abf5p-55; 0x97195d4cfcda7p-56; 0x151980c289ba49p-60]);
  (11%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (11%nat, 0x10000000000001p-52, [0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (11%nat, 2, [0; 0; 0; 0; 0; 0; 0; 0; 0; 1])]);
(9%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x48ac926cc90a5p-51; 0x48ac926cc90a5p-51; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(9%nat, -1, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (9%nat, 0x1p-1074, [1; 0x9p-1073; 0; 0; 0; 0; 0; 0; 0; 0]);
  (9%nat, 0x762a2bb33a04dp-52, [0x12c9455c905bf3p-74; 0xb7bd8567a4977p-68; 0xa684d9a61e739p-57; 0x1a8602d6f6b4b9p-56; 0xeccf61a366b0dp-54; 0x253c95bb8bcddp-51; 0xe348f22cf00d5p-54; 0x1a3cf0b5fcbf9bp-56; 0x1b1e304cd8abdfp-58; 0x182b96f42c6613p-61]);
  (11%nat, 0x1f95a713b177cbp-53, [0x1027ef1788241fp-106; 0x15825a019d7b47p-97; 0xcb7097b80aa0dp-88; 0x1183a44a8cf481p-81; 0x1ef44685621535p-75; 0x122d13b0a1bb79p-68; 0x71306dbed5a7bp-61; 0x6ff90371a8fddp-56; 0xd8e044c004e01p-54; 0x1851d3f52e4bd1p-53]);
  (11%nat, 0x1fffffffffffffp-53, [0x15690a8c0e2db1p-527; 0xc0b15eec7f9b3p-470; 0x18162bdd8ff365p-416; 0x7067775f4a6fdp-360; 0xa89b330eefa7bp-307; 0x544d998777d3dp-253; 0x1c19ddd7d29befp-203; 0x18162bdd8ff35dp-151; 0x29a4e760eaba3p-98; 0xffffffffffff7p-52]);
  (11%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (11%nat, 2, [0; 0; 0; 0; 0; 0; 0; 0; 0; 1])]);
(9%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x420501bc66b55p-52; 0x420501bc66b55p-52; 0x420501bc66b55p-52; 0x420501bc66b55p-52; 0x420501bc66b55p-52; 0x420501bc66b55p-52; 0x420501bc66b55p-52; 0x420501bc66b55p-52; 0x420501bc66b55p-52; 0xdab652fccc7e3p-53; 0xdab652fccc7e3p-53; 0xdab652fccc7e3p-53; 0xdab652fccc7e3p-53; 0xdab652fccc7e3p-53; 0x1312a725571d33p-53; 0x1312a725571d33p-53; 0x1312a725571d33p-53; 0x1312a725571d33p-53; 0x1312a725571d33p-53; 0x1312a725571d33p-53; 0x1312a725571d33p-53; 0x1312a725571d33p-53; 0x1312a725571d33p-53; 0x1531ac208b853p-49; 0x1531ac208b853p-49; 0x1531ac208b853p-49; 0x1531ac208b853p-49; 0x1531ac208b853p-49; 0x1531ac208b853p-49; 0x1531ac208b853p-49; 0x1531ac208b853p-49; 1; 1; 1; 1; 1; 1; 1; 1; 1; 1],
 [(9%nat, -1, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (9%nat, 0, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (23%nat, 0x9450084da0b9p-48, [0x1ea1bd67c38c7dp-87; 0x509cf26393093p-77; 0x17660fc1452bb3p-73; 0xfadf871b56cbdp-67; 0xd4ab381ae334fp-62; 0x74e11beba724dp-58; 0x1636b43b47b457p-57; 0x56d9825ff02a7p-53; 0x18c27000fe273dp-54; 0x1918dcf5851293p-54]);
  (32%nat, 0x4c4a9c955c74dp-51, [0x1fffffffffff79p-53; 0x43e317062baa3p-96; 0x8004a715d46a3p-144; 0x8cd2a34e97529p-192; 0x31cabae8ed3b1p-239; 0x5de52bcf04bc7p-289; 0x1d82b0bc4d3129p-341; 0x17d98b909be1c1p-391; 0xb3e62cbf313bp-437; 0xc5ec0a73a2ad5p-496]);
  (40%nat, 0xf86668ccf7d33p-52, [0x120532156ad2bbp-84; 0x1f81ba6c797419p-78; 0xa32696ac6facfp-71; 0x1edb07ae4cef19p-68; 0x3c05b8e66a765p-61; 0x1375bd1b6e1161p-60; 0x10d3070869d0ddp-57; 0x959ce242af449p-54; 0xc2064be749567p-53; 0x1bf52f2d36e36bp-54]);
  (40%nat, 0x1fffffffffffffp-53, [0x1c97f3d8d8565p-512; 0xcfeb24421c61fp-460; 0x46361603dbf7dp-405; 0x375269dcd363p-348; 0xe02d776ed6bf9p-302; 0x12ece965b5d0dp-247; 0x2215a8da445cfp-197; 0x277669d70bbfdp-147; 0x6a9b9659fb1dp-95; 0x3fffffffffffdp-50]);
  (40%nat, 2, [0; 0; 0; 0; 0; 0; 0; 0; 0; 1])]);
(9%nat, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; 0xdcc52d9cfaaadp-52; 0x1e2f8b7f00018fp-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49],
 [(9%nat, -0x9333333333333p-50, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (9%nat, -0x14cccccccccccdp-52, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (10%nat, 0x1b98a5b39f555bp-53, [0x3bb7a48f6d2b1p-63; 0x5b966c4334c81p-58; 0x4ca7ddef3491bp-55; 0x7da36e021cb2dp-54; 0x1e557272f57b7bp-55; 0x919b9cfbdcfadp-53; 0xd6ae8734b747dp-54; 0x165c63a412c4b5p-56; 0x102e7d1b65d55fp-58; 0xfffba9d1c4dd1p-534]);
  (10%nat, 0x111bea06c17e3bp-52, [0x1f554c076fbc23p-69; 0x1ad65599e08dafp-62; 0x7dc3b6b731171p-57; 0x8b6151c6d1b29p-55; 0xb3cd7c56ef485p-54; 0x23d1340e2f2f7p-51; 0x8bd5eefeaafefp-53; 0x1341ae99152589p-55; 0x126a8f9f569e5p-53; 0x1757ce2e4449a7p-78]);
  (10%nat, 0x119b111a8d7457p-52, [0x5873d37150257p-67; 0x15e1d6349ec83p-58; 0xd815c3d363f35p-58; 0x3ebf4dafc247dp-54; 0xa95c9ccca1669p-54; 0x11a233aeab3731p-54; 0x11fc934e8e4aebp-54; 0x14b58a600d89d3p-55; 0x14b4882737167bp-57; 0x148837f9e01ca9p-76]);
  (11%nat, 0x13333333333333p-51, [0x117d8cd0d5f9dp-520; 0x2466e6ac3d565p-465; 0x86afef16e2f29p-412; 0x122b330d5a9d41p-359; 0x19358a08edba2fp-306; 0x175186150f1903p-253; 0x7309a68a06371p-199; 0x16cd5769129a71p-149; 0x8c3e5d8c8a539p-98; 0xfffffffffffddp-52]);
  (11%nat, 0x6cccccccccccdp-49, [0; 0; 0; 0; 0; 0; 0; 0; 0; 1])])].

Definition rows_10 : list (nat * list float * list (nat * float * list float)) := [
(9%nat, [0; 0; 0; 0; 0; 0; 0; 0; 0; 0; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400],
 [(9%nat, -1, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (9%nat, -0x1p-1074, [1; 0; 0; 0; 0; 0; 0; 0; 0; 0]);
  (9%nat, 0xc8503208a5f59p-452, [0x925b9dd2e7c35p-71; 0x12823c07790c7bp-67; 0x85283b8a6d163p-62; 0x45da210d1e997p-58; 0x5e39ba9be4a0dp-56; 0xa978ad83a9285p-55; 0x32cd14cc0bbffp-52; 0x272888e848be1p-51; 0x466dda35d1fbdp-52; 0x384c715aa333bp-53]);
  (9%nat, 0x6c528312d9b4fp-451, [0xcdfc4a221c44dp-76; 0x13ee9e2935918bp-71; 0xdb7214c578ea1p-66; 0xb02b116eac8e1p-62; 0xb5d54071e3871p-59; 0x7d1eb61045c3fp-56; 0xe59688960ffabp-55; 0x10ed2cf5e7d17bp-54; 0x174b59201ee79bp-54; 0xe3f77ded4e6ddp-54]);
  (9%nat, 0x1p-400, [0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (9%nat, 0x10000000000001p-452, [0; 0; 0; 0; 0; 0; 0; 0; 0; 1]);
  (9%nat, 1, [0; 0; 0; 0; 0; 0; 0; 0; 0; 1])]);
(9%nat, [-0x1b223e2a26d6edp-53; -0x178888b0ce8b23p-53; -0x14d14e0c596fb1p-53; -0x107e9f83524ea3p-53; -0xe9587d2c90b09p-53; -0xca00d53f5a0fdp-53; -0x957e6625afe23p-53; -0x17a366f3952fdp-51; -0x5584436f66cbbp-53; -0x1022aa850a1b7p-51; 0x8286e2c2a04ffp-51; 0x10b9e8d48aa8fbp-52; 0xad767341126d7p-51; 0xb617af611db6bp-51; 0xbbca04d82a4c1p-51; 0x60755e4dae947p-50; 0x60a87150c9fe9p-50; 0x1a826e5ee28d33p-52; 0x1bea7c872e67dfp-52; 0x1f23562a52c0cbp-52],
 [(9%nat, -0xec88f8a89b5bbp-51, [0x1598466f8a676fp-55; 0x19be6745e1686dp-54; 0x55299ec01b5e3p-52; 0xb0738a287956bp-55; 0x1417808a9ebde9p-59; 0x6aa0e50e89dd5p-62; 0x16dbe74c34580fp-71; 0xea53939e9ea89p-83; 0x132887b44e2c25p-94; 0]);
  (9%nat, -0x1022aa850a1b7p-51, [0x1598466f8a676fp-55; 0x19be6745e1686dp-54; 0x55299ec01b5e3p-52; 0xb0738a287956bp-55; 0x1417808a9ebde9p-59; 0x6aa0e50e89dd5p-62; 0x16dbe74c34580fp-71; 0xea53939e9ea89p-83; 0x132887b44e2c25p-94; 0]);
  (9%nat, 0x74019c7322bfp-50, [0x14f806574c59dbp-58; 0x1045e25c15551dp-55; 0xb0d7c8b8581e9p-53; 0x14890ad5e973bp-50; 0x97828ab478de3p-54; 0x8cd3adb997d4fp-56; 0x7604062219867p-59; 0x17b6cef2eb2657p-65; 0xd009167db77e1p-69; 0xfd2fc4df6668bp-76]);
  (9%nat, 0x12260a86fd388dp-53, [0xa5aa858ee9d13p-66; 0x119af23dd6aa63p-62; 0xca809b866a57dp-57; 0x3da2d3e83041dp-53; 0x88702b0566dffp-53; 0x27fd34638f231p-51; 0x636941b6be50fp-53; 0x8a11463904cddp-55; 0x19870d11e05bedp-59; 0x1bb2970cb91235p-63]);
  (9%nat, 0x1050dc585409fdp-52, [0x196065e3ef73afp-525; 0x1f87281f07f3b9p-99; 0x8009346d3e5bfp-67; 0x1839cd9226afa3p-63; 0x56e231cd01efbp-57; 0x116d1c40497645p-56; 0x1aaa225973dbb7p-55; 0xb5f3c2066ceebp-53; 0x11dba29a048593p-54; 0x13edae6591095bp-56]);
  (9%nat, 0x1050dc585409ffp-52, [0; 0xfc3940f83f87fp-98; 0x8009346d3e5b1p-67; 0x1839cd9226af85p-63; 0x15b88c73407bd7p-59; 0x116d1c40497639p-56; 0x6aa88965cf6ebp-53; 0x5af9e10336775p-52; 0x11dba29a048597p-54; 0x4fb6b99644259p-54]);
  (9%nat, 0xbc8d58a94b033p-50, [0; 0xfc3940f83f87fp-98; 0x8009346d3e5b1p-67; 0x1839cd9226af85p-63; 0x15b88c73407bd7p-59; 0x116d1c40497639p-56; 0x6aa88965cf6ebp-53; 0x5af9e10336775p-52; 0x11dba29a048597p-54; 0x4fb6b99644259p-54])])].

Definition rows := rows_0 ++ rows_1 ++ rows_2 ++ rows_3 ++ rows_4 ++ rows_5 ++ rows_6 ++ rows_7 ++ rows_8 ++ rows_9 ++ rows_10.

Definition derivatives : list (nat * list float * nat * nat * float * list float * list float) := [
(1, [0; 0; 0x1p-59; 0x1p-53; 0x1p-32; 0x1p-27; 1; 1]%float, 1, 3, -1%float, []%float, [1; 0; -0x1p59; 0x1p59; 0; 0; 0; 0]%float);
(1, [0; 0; 0x1p-59; 0x1p-53; 0x1p-32; 0x1p-27; 1; 1]%float, 1, 3, 0x1fffffffffffffp-112%float, []%float, [0x1p-53; 0x1fffffffffffffp-53; -0x1p59; 0x1p59; 0; 0; 0; 0]%float);
(1, [0; 0; 0x1p-59; 0x1p-53; 0x1p-32; 0x1p-27; 1; 1]%float, 3, 1, 0x10000000000001p-105%float, []%float, [1; 0x40000200001p-115; -0x40000200001p-10; 0x40000200001p-10]%float);
(1, [0; 0; 0x1p-59; 0x1p-53; 0x1p-32; 0x1p-27; 1; 1]%float, 5, 1, 0x48beab12cd75dp-52%float, []%float, [0xb74155041ab4dp-52; 0x48beaafbe54b3p-52; -0x8000001p-27; 0x8000001p-27]%float);
(1, [0; 0; 0x1p-59; 0x1p-53; 0x1p-32; 0x1p-27; 1; 1]%float, 5, 3, 0x1f26838f87a893p-53%float, []%float, [0xd97c709386fb1p-57; 0x7c9a0e3db1e41p-51; -0x8000001p-27; 0x8000001p-27; 0; 0; 0; 0]%float);
(1, [0; 0; 0x1p-59; 0x1p-53; 0x1p-32; 0x1p-27; 1; 1]%float, 5, 3, 1%float, []%float, [0; 1; -0x8000001p-27; 0x8000001p-27; 0; 0; 0; 0]%float);
(1, [0; 0; 0x1p-59; 0x1p-53; 0x1p-32; 0x1p-27; 1; 1]%float, 5, 2, 2%float, []%float, [0; 1; -0x8000001p-27; 0x8000001p-27; 0; 0]%float);
(1, [0; 0; 0x158a064de1bf69p-53; 0xac50326f0dfb5p-52; 0x158a064de1bf6bp-53; 1; 1]%float, 1, 2, -1%float, []%float, [1; 0; -0x5f1527acfb479p-50; 0x5f1527acfb479p-50; 0; 0]%float);
(1, [0; 0; 0x158a064de1bf69p-53; 0xac50326f0dfb5p-52; 0x158a064de1bf6bp-53; 1; 1]%float, 1, 3, 0xbbf7a7a31f84dp-53%float, []%float, [0x745f20aff2fa9p-52; 0x8ba0df500d057p-52; -0x5f1527acfb479p-50; 0x5f1527acfb479p-50; 0; 0; 0; 0]%float);
(1, [0; 0; 0x158a064de1bf69p-53; 0xac50326f0dfb5p-52; 0x158a064de1bf6bp-53; 1; 1]%float, 1, 3, 0xaa2ca1a58946dp-52%float, []%float, [0x196bff50ba89bfp-59; 0x1f9a5002bd15d9p-53; -0x5f1527acfb479p-50; 0x5f1527acfb479p-50; 0; 0; 0; 0]%float);
(1, [0; 0; 0x158a064de1bf69p-53; 0xac50326f0dfb5p-52; 0x158a064de1bf6bp-53; 1; 1]%float, 2, 3, 0x158a064de1bf69p-53%float, []%float, [1; 0; -0x1p53; 0x1p53; 0; 0; 0; 0]%float);
(1, [0; 0; 0x158a064de1bf69p-53; 0xac50326f0dfb5p-52; 0x158a064de1bf6bp-53; 1; 1]%float, 3, 1, 0xac50326f0dfb5p-52%float, []%float, [1; 0; -0x1p53; 0x1p53]%float);
(1, [0; 0; 0x158a064de1bf69p-53; 0xac50326f0dfb5p-52; 0x158a064de1bf6bp-53; 1; 1]%float, 4, 3, 0x5628193786fdbp-51%float, []%float, [0x1ffffffffffffdp-53; 0x1878e35936f7e9p-104; -0x1878e35936f7e9p-51; 0x1878e35936f7e9p-51; 0; 0; 0; 0]%float);
(1, [0; 0; 0x158a064de1bf69p-53; 0xac50326f0dfb5p-52; 0x158a064de1bf6bp-53; 1; 1]%float, 4, 2, 2%float, []%float, [0; 1; -0x1878e35936f7e9p-51; 0x1878e35936f7e9p-51; 0; 0]%float);
(1, [0; 0; 0xad3bf7c68cb73p-54; 0x1720cd30861a05p-53; 1; 1]%float, 1, 3, -1%float, []%float, [1; 0; -0xbd277efe66939p-49; 0xbd277efe66939p-49; 0; 0; 0; 0]%float);
(1, [0; 0; 0xad3bf7c68cb73p-54; 0x1720cd30861a05p-53; 1; 1]%float, 1, 1, 0x1p-1074%float, []%float, [1; 0x3p-1073; -0xbd277efe66939p-49; 0xbd277efe66939p-49]%float);
(1, [0; 0; 0xad3bf7c68cb73p-54; 0x1720cd30861a05p-53; 1; 1]%float, 2, 2, 0x277de46b410d9p-51%float, []%float, [0x17f1c9dcdaaf39p-53; 0x101c6c464aa18dp-54; -0x39ce38d0f93d7p-49; 0x39ce38d0f93d7p-49; 0; 0]%float);
(1, [0; 0; 0xad3bf7c68cb73p-54; 0x1720cd30861a05p-53; 1; 1]%float, 2, 1, 0x78255d61643f7p-52%float, []%float, [0x1d4cbe6368718bp-54; 0x8acd06725e39dp-52; -0x39ce38d0f93d7p-49; 0x39ce38d0f93d7p-49]%float);
(1, [0; 0; 0xad3bf7c68cb73p-54; 0x1720cd30861a05p-53; 1; 1]%float, 3, 1, 0x1720cd30861a05p-53%float, []%float, [1; 0; -0x1cdaf1aac82e61p-51; 0x1cdaf1aac82e61p-51]%float);
(1, [0; 0; 0xad3bf7c68cb73p-54; 0x1720cd30861a05p-53; 1; 1]%float, 3, 2, 0x1fffffffffffffp-53%float, []%float, [0x1cdaf1aac82e61p-104; 0x7ffffffffffffp-51; -0x1cdaf1aac82e61p-51; 0x1cdaf1aac82e61p-51; 0; 0]%float);
(1, [0; 0; 0xad3bf7c68cb73p-54; 0x1720cd30861a05p-53; 1; 1]%float, 3, 2, 2%float, []%float, [0; 1; -0x1cdaf1aac82e61p-51; 0x1cdaf1aac82e61p-51; 0; 0]%float);
(1, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x156e3f69813adfp-53; 0x14024177e9619p-51; 0x8eeb9ce144f63p-52; 0xe5104a0474be3p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 1, 2, -0x9333333333333p-50%float, []%float, [1; 0; -0x196293314db80dp-52; 0x196293314db80dp-52; 0; 0]%float);
(1, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x156e3f69813adfp-53; 0x14024177e9619p-51; 0x8eeb9ce144f63p-52; 0xe5104a0474be3p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 1, 2, -0x14cccccccccccdp-52%float, []%float, [1; 0; -0x196293314db80dp-52; 0x196293314db80dp-52; 0; 0]%float);
(1, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x156e3f69813adfp-53; 0x14024177e9619p-51; 0x8eeb9ce144f63p-52; 0xe5104a0474be3p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 1, 1, -0xab71fb4c09d7p-48%float, []%float, [0x196293314db80dp-105; 0x1fffffffffffffp-53; -0x196293314db80dp-52; 0x196293314db80dp-52]%float);
(1, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x156e3f69813adfp-53; 0x14024177e9619p-51; 0x8eeb9ce144f63p-52; 0xe5104a0474be3p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 4, 3, 0xba9610f1e3c05p-52%float, []%float, [0x1f8efc7a8ebef3p-54; 0x81c40e15c5043p-52; -0x17c63baacdc00bp-51; 0x17c63baacdc00bp-51; 0; 0; 0; 0]%float);
(1, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x156e3f69813adfp-53; 0x14024177e9619p-51; 0x8eeb9ce144f63p-52; 0xe5104a0474be3p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 5, 3, 0x1ca209408e97c7p-53%float, []%float, [1; 0x154264a1720ee9p-106; -0x154264a1720ee9p-53; 0x154264a1720ee9p-53; 0; 0; 0; 0]%float);
(1, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x156e3f69813adfp-53; 0x14024177e9619p-51; 0x8eeb9ce144f63p-52; 0xe5104a0474be3p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 5, 1, 0x86ad2cfe43bb5p-50%float, []%float, [0x1924d4d07a2bd9p-55; 0xcdb6565f0ba85p-52; -0x2a84c942e41ddp-50; 0x2a84c942e41ddp-50]%float);
(1, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x156e3f69813adfp-53; 0x14024177e9619p-51; 0x8eeb9ce144f63p-52; 0xe5104a0474be3p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 5, 2, 0x6cccccccccccdp-49%float, []%float, [0; 1; -0x2a84c942e41ddp-50; 0x2a84c942e41ddp-50; 0; 0]%float);
(1, [0; 0; 0x41c34515804f9p-451; 0x127d4b8969c0b3p-453; 0x1e7a9ce363ccdp-449; 0x1p-400; 0x1p-400]%float, 1, 1, -1%float, []%float, [1; 0; -0x3e48d391a8b1bp351; 0x3e48d391a8b1bp351]%float);
(1, [0; 0; 0x41c34515804f9p-451; 0x127d4b8969c0b3p-453; 0x1e7a9ce363ccdp-449; 0x1p-400; 0x1p-400]%float, 2, 2, 0x93ea5c4b4e059p-452%float, []%float, [0x1f3d1ba3ddf66dp-102; 0x1ffffffffffffp-49; -0x1f3d1ba3ddf66dp351; 0x1f3d1ba3ddf66dp351; 0; 0]%float);
(1, [0; 0; 0x41c34515804f9p-451; 0x127d4b8969c0b3p-453; 0x1e7a9ce363ccdp-449; 0x1p-400; 0x1p-400]%float, 3, 1, 0x9be3cedea0b25p-452%float, []%float, [0x755bb0f75ac97p-51; 0x15489e114a6d21p-56; -0x155a1b1bcc18e9p349; 0x155a1b1bcc18e9p349]%float);
(1, [0; 0; 0x41c34515804f9p-451; 0x127d4b8969c0b3p-453; 0x1e7a9ce363ccdp-449; 0x1p-400; 0x1p-400]%float, 3, 1, 0x17573f0c05d89dp-453%float, []%float, [0x261a78ca6f635p-50; 0x19e58735909cafp-54; -0x155a1b1bcc18e9p349; 0x155a1b1bcc18e9p349]%float);
(1, [0; 0; 0x41c34515804f9p-451; 0x127d4b8969c0b3p-453; 0x1e7a9ce363ccdp-449; 0x1p-400; 0x1p-400]%float, 4, 2, 0x1e7a9ce363ccdp-449%float, []%float, [1; 0; -0x1509c6a8a66cbfp352; 0x1509c6a8a66cbfp352; 0; 0]%float);
(1, [0; 0; 0x41c34515804f9p-451; 0x127d4b8969c0b3p-453; 0x1e7a9ce363ccdp-449; 0x1p-400; 0x1p-400]%float, 4, 2, 0x10000000000001p-452%float, []%float, [0; 1; -0x1509c6a8a66cbfp352; 0x1509c6a8a66cbfp352; 0; 0]%float);
(1, [0; 0; 0x41c34515804f9p-451; 0x127d4b8969c0b3p-453; 0x1e7a9ce363ccdp-449; 0x1p-400; 0x1p-400]%float, 4, 2, 1%float, []%float, [0; 1; -0x1509c6a8a66cbfp352; 0x1509c6a8a66cbfp352; 0; 0]%float);
(1, [-0x109b9793e6667p-50; -0x30dc351bdd305p-52; 0xc89da11b6c209p-52; 0x6905aeaf463b3p-51; 0xe2dcaa3e07db9p-52; 0x184c81998e07p-44; 0x18fb526269355dp-52]%float, 1, 1, -0x509b9793e6667p-50%float, []%float, [1; 0; -0x106b1d701026b1p-52; 0x106b1d701026b1p-52]%float);
(1, [-0x109b9793e6667p-50; -0x30dc351bdd305p-52; 0xc89da11b6c209p-52; 0x6905aeaf463b3p-51; 0xe2dcaa3e07db9p-52; 0x184c81998e07p-44; 0x18fb526269355dp-52]%float, 1, 1, -0x186e1a8dee9829p-55%float, []%float, [1; 0; -0x106b1d701026b1p-52; 0x106b1d701026b1p-52]%float);
(1, [-0x109b9793e6667p-50; -0x30dc351bdd305p-52; 0xc89da11b6c209p-52; 0x6905aeaf463b3p-51; 0xe2dcaa3e07db9p-52; 0x184c81998e07p-44; 0x18fb526269355dp-52]%float, 1, 2, 0x19130d3895e77bp-53%float, []%float, [0x156909a7272c2dp-66; 0x1fff54b7b2c6c7p-53; -0x106b1d701026b1p-52; 0x106b1d701026b1p-52; 0; 0]%float);
(1, [-0x109b9793e6667p-50; -0x30dc351bdd305p-52; 0xc89da11b6c209p-52; 0x6905aeaf463b3p-51; 0xe2dcaa3e07db9p-52; 0x184c81998e07p-44; 0x18fb526269355dp-52]%float, 4, 2, 0xe2dcaa3e07db9p-52%float, []%float, [1; 0; -0x3297ce22fa2e9p-49; 0x3297ce22fa2e9p-49; 0; 0]%float);
(1, [-0x109b9793e6667p-50; -0x30dc351bdd305p-52; 0xc89da11b6c209p-52; 0x6905aeaf463b3p-51; 0xe2dcaa3e07db9p-52; 0x184c81998e07p-44; 0x18fb526269355dp-52]%float, 4, 2, 0x1c5b9547c0fb73p-53%float, []%float, [0xfffffffffffffp-52; 0x3297ce22fa2e9p-102; -0x3297ce22fa2e9p-49; 0x3297ce22fa2e9p-49; 0; 0]%float);
(1, [-0x109b9793e6667p-50; -0x30dc351bdd305p-52; 0xc89da11b6c209p-52; 0x6905aeaf463b3p-51; 0xe2dcaa3e07db9p-52; 0x184c81998e07p-44; 0x18fb526269355dp-52]%float, 4, 1, 0x14be4848c8bac5p-52%float, []%float, [0x167c5e50752d1p-50; 0x2983a1af8ad2fp-50; -0x3297ce22fa2e9p-49; 0x3297ce22fa2e9p-49]%float);
(1, [-0x109b9793e6667p-50; -0x30dc351bdd305p-52; 0xc89da11b6c209p-52; 0x6905aeaf463b3p-51; 0xe2dcaa3e07db9p-52; 0x184c81998e07p-44; 0x18fb526269355dp-52]%float, 4, 1, 0xa3ed4989a4d57p-50%float, []%float, [0; 1; -0x3297ce22fa2e9p-49; 0x3297ce22fa2e9p-49]%float);
(2, [0; 0; 0; 0x1p-60; 1; 1; 1]%float, 2, 3, -1%float, []%float, [1; 0; 0; -0x1p61; 0x1p61; 0; 0x1p121; -0x1p121; 0x1p61; 0; 0; 0]%float);
(2, [0; 0; 0; 0x1p-60; 1; 1; 1]%float, 2, 2, 0x1fffffffffffffp-113%float, []%float, [0x1p-106; 1; 0xfffffffffffffp-112; -256; 254; 0x1fffffffffffffp-52; 0x1p121; -0x1p121; 0x1p61]%float);
(2, [0; 0; 0; 0x1p-60; 1; 1; 1]%float, 3, 1, 0x10000000000001p-112%float, []%float, [1; 0x8000000000001p-111; 0x1p-224; -2; 2; 0x1p-111]%float);
(2, [0; 0; 0; 0x1p-60; 1; 1; 1]%float, 3, 3, 0x350bdcd58989p-47%float, []%float, [0xaf90693cd21a1p-53; 0x1f1008db41f07bp-54; 0x15fbd3fa479885p-55; -0x4af4232a7677p-46; 0xaf4232a7677p-45; 0x350bdcd58989p-46; 2; -4; 2; 0; 0; 0]%float);
(2, [0; 0; 0; 0x1p-60; 1; 1; 1]%float, 3, 3, 0x1a06f9bd6d5a59p-53%float, []%float, [0x8eb1ef1d8bbbdp-56; 0x136e89915e38bdp-54; 0xa95abac8ae615p-52; -0x5f9064292a5a7p-52; -0xa06f9bd6d5a59p-51; 0x1a06f9bd6d5a59p-52; 2; -4; 2; 0; 0; 0]%float);
(2, [0; 0; 0; 0x1p-60; 1; 1; 1]%float, 3, 3, 1%float, []%float, [0; 0; 1; 0; -2; 2; 2; -4; 2; 0; 0; 0]%float);
(2, [0; 0; 0; 0x1p-60; 1; 1; 1]%float, 3, 2, 2%float, []%float, [0; 0; 1; 0; -2; 2; 2; -4; 2]%float);
(2, [0; 0; 0; 1; 1; 1]%float, 2, 3, -1%float, []%float, [1; 0; 0; -2; 2; 0; 2; -4; 2; 0; 0; 0]%float);
(2, [0; 0; 0; 1; 1; 1]%float, 2, 3, 0x1p-1074%float, []%float, [1; 0x1p-1073; 0; -2; 2; 0x1p-1073; 2; -4; 2; 0; 0; 0]%float);
(2, [0; 0; 0; 1; 1; 1]%float, 2, 2, 0xa2a7ae05abb6fp-52%float, []%float, [0x1104a5042bcbb3p-55; 0x1da783f8fe58d5p-54; 0x19d62984ebc151p-54; -0x5d5851fa54491p-51; -0x22a7ae05abb6fp-50; 0xa2a7ae05abb6fp-51; 2; -4; 2]%float);
(2, [0; 0; 0; 1; 1; 1]%float, 2, 1, 0x66fc2203ac765p-51%float, []%float, [0x4e382d47970f5p-55; 0x14205b27da18bbp-54; 0x14b6f1b6f49765p-53; -0x1903ddfc5389bp-50; -0x26fc2203ac765p-49; 0x66fc2203ac765p-50]%float);
(2, [0; 0; 0; 1; 1; 1]%float, 2, 2, 0x1fffffffffffffp-53%float, []%float, [0x1p-106; 0x1fffffffffffffp-105; 0xfffffffffffffp-52; -0x1p-52; -0xfffffffffffffp-51; 0x1fffffffffffffp-52; 2; -4; 2]%float);
(2, [0; 0; 0; 1; 1; 1]%float, 2, 1, 1%float, []%float, [0; 0; 1; 0; -2; 2]%float);
(2, [0; 0; 0; 1; 1; 1]%float, 2, 2, 2%float, []%float, [0; 0; 1; 0; -2; 2; 2; -4; 2]%float);
(2, [0; 0; 0; 0x80fd92bc983c5p-54; 0xaa95dd25b0f23p-54; 0x914c2e9e3a62dp-52; 0x17a3d974f69a63p-53; 0x17a3d974f69a63p-53; 1; 1; 1]%float, 2, 1, -1%float, []%float, [1; 0; 0; -0x7f045fbe9e879p-47; 0x7f045fbe9e879p-47; 0]%float);
(2, [0; 0; 0; 0x80fd92bc983c5p-54; 0xaa95dd25b0f23p-54; 0x914c2e9e3a62dp-52; 0x17a3d974f69a63p-53; 0x17a3d974f69a63p-53; 1; 1; 1]%float, 2, 2, -0x1p-1074%float, []%float, [1; 0; 0; -0x7f045fbe9e879p-47; 0x7f045fbe9e879p-47; 0; 0xfc155c490c39fp-45; -0x1bab327efe6a69p-45; 0x17d3b974db4d95p-46]%float);
(2, [0; 0; 0; 0x80fd92bc983c5p-54; 0xaa95dd25b0f23p-54; 0x914c2e9e3a62dp-52; 0x17a3d974f69a63p-53; 0x17a3d974f69a63p-53; 1; 1; 1]%float, 2, 2, 0x380ee4b306c3p-49%float, []%float, [0x8c30cd14b3b25p-57; 0x1a57ffbb0d72dp-50; 0x923e7aab24973p-52; -0x84ed950f8cf55p-50; -0x42dd844d01ae9p-47; 0xa6f66ddde69a7p-48; 0xfc155c490c39fp-45; -0x1bab327efe6a69p-45; 0x17d3b974db4d95p-46]%float);
(2, [0; 0; 0; 0x80fd92bc983c5p-54; 0xaa95dd25b0f23p-54; 0x914c2e9e3a62dp-52; 0x17a3d974f69a63p-53; 0x17a3d974f69a63p-53; 1; 1; 1]%float, 4, 1, 0x1552bba4b61e47p-55%float, []%float, [0x1d0e78ca9ff8b9p-53; 0x5e30e6ac00e91p-54; 0x116f4ad762b449p-160; -0x121daaa2a3b7b1p-50; 0x121daaa2a3b7b1p-50; 0x116f4ad762b449p-104]%float);
(2, [0; 0; 0; 0x80fd92bc983c5p-54; 0xaa95dd25b0f23p-54; 0x914c2e9e3a62dp-52; 0x17a3d974f69a63p-53; 0x17a3d974f69a63p-53; 1; 1; 1]%float, 4, 3, 0x7fc63a11316d1p-53%float, []%float, [0x248d30623e6e7p-50; 0xcc39749bb4381p-53; 0x7ae84292c2a33p-56; -0x1cbc0fc35b1df5p-51; 0xb795ffd2c1e2bp-50; 0x5c94fc902e19fp-51; 0x1696e5219d078dp-49; -0xa018bfe3feef5p-47; 0x22de95aec5689p-46; 0; 0; 0]%float);
(2, [0; 0; 0; 0x80fd92bc983c5p-54; 0xaa95dd25b0f23p-54; 0x914c2e9e3a62dp-52; 0x17a3d974f69a63p-53; 0x17a3d974f69a63p-53; 1; 1; 1]%float, 5, 3, 0x914c2e9e3a62dp-52%float, []%float, [0x992eb0427910dp-53; 0xb368a7dec3779p-52; 0; -0x6fdb278ae0c85p-49; 0x6fdb278ae0c85p-49; 0; 0xa35ba3bf61ccdp-47; -0x162af3dd5d8d75p-46; 0x111016bf627f0fp-46; 0; 0; 0]%float);
(2, [0; 0; 0; 0x80fd92bc983c5p-54; 0xaa95dd25b0f23p-54; 0x914c2e9e3a62dp-52; 0x17a3d974f69a63p-53; 0x17a3d974f69a63p-53; 1; 1; 1]%float, 7, 1, 2%float, []%float, [0; 0; 1; 0; -0x3d3e89be7c94fp-47; 0x3d3e89be7c94fp-47]%float);
(2, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x15c5820c099c61p-53; -0x13bdfdd34d735fp-53; -0x5b0f2dd18ee3bp-52; -0x39d7ba97c4f61p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 2, 2, -0x9333333333333p-50%float, []%float, [1; 0; 0; -0xce924e9b57e3dp-50; 0xce924e9b57e3dp-50; 0; 0x14d5f943f858bdp-50; -0x13de5c6b004fa7p-49; 0x12e6bf9208469p-46]%float);
(2, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x15c5820c099c61p-53; -0x13bdfdd34d735fp-53; -0x5b0f2dd18ee3bp-52; -0x39d7ba97c4f61p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 3, 2, -0x15c5820c099c61p-53%float, []%float, [0x17c4994b00b117p-56; 0x1d076cd69fe9ddp-53; 0; -0x176c90baa7b509p-51; 0x176c90baa7b509p-51; 0; 0x1715ce3ad048d9p-47; -0x23d3c84e31dc9p-42; 0x612384c326e09p-44]%float);
(2, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x15c5820c099c61p-53; -0x13bdfdd34d735fp-53; -0x5b0f2dd18ee3bp-52; -0x39d7ba97c4f61p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 4, 1, -0x9defee9a6b9afp-52%float, []%float, [0x19bfcfabce851bp-53; 0xc8060a862f5cbp-54; 0x4e521a0cd15b9p-153; -0x629096ffa1907p-48; 0xc5212dff4320dp-49; 0x4e521a0cd15b9p-99]%float);
(2, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x15c5820c099c61p-53; -0x13bdfdd34d735fp-53; -0x5b0f2dd18ee3bp-52; -0x39d7ba97c4f61p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 6, 3, -0x35db3fc090365p-52%float, []%float, [0x1e21f97e1c1eadp-53; 0x1ddbcc44bf1cf7p-57; 0x126f65fbe12425p-67; -0xb8b1e88f6b729p-52; 0x16f13db6cd6c9fp-53; 0x127fad9000d94fp-60; 0x236087977e707p-51; -0x48808ea04f58fp-51; 0x1290038468743fp-54; 0; 0; 0]%float);
(2, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x15c5820c099c61p-53; -0x13bdfdd34d735fp-53; -0x5b0f2dd18ee3bp-52; -0x39d7ba97c4f61p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 6, 3, 0x1192d7d8440933p-52%float, []%float, [0xefc19d1506c8fp-54; 0x82f3c115f7ff7p-52; 0x1046f5e9319397p-54; -0x170636d639f787p-54; -0x18edeb3b6dc9p-50; 0x18951589f0d417p-54; 0x11b043cbbf3837p-54; -0x48808ea04f58fp-51; 0x1290038468743fp-54; 0; 0; 0]%float);
(2, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x15c5820c099c61p-53; -0x13bdfdd34d735fp-53; -0x5b0f2dd18ee3bp-52; -0x39d7ba97c4f61p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 6, 2, 0x13333333333333p-51%float, []%float, [0x11b043cbbf3837p-157; 0x185f45406d5dafp-104; 0x1ffffffffffffdp-53; -0x11b043cbbf3837p-105; -0xc2fa2a036aed7p-52; 0x185f45406d5dafp-53; 0x11b043cbbf3837p-54; -0x122023a813d63bp-53; 0x94801c2343a1fp-53]%float);
(2, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x15c5820c099c61p-53; -0x13bdfdd34d735fp-53; -0x5b0f2dd18ee3bp-52; -0x39d7ba97c4f61p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 6, 1, 0x6cccccccccccdp-49%float, []%float, [0; 0; 1; 0; -0x185f45406d5db1p-53; 0x185f45406d5db1p-53]%float);
(2, [0; 0; 0; 0x3a773241833a9p-453; 0x7f1a354f2921dp-452; 0x1p-400; 0x1p-400; 0x1p-400]%float, 2, 3, -1%float, []%float, [1; 0; 0; -0x1183bad39da5adp352; 0x1183bad39da5adp352; 0; 0x132c298d7db889p755; -0x5e540b4aa5535p757; 0x8d1b28a573897p754; 0; 0; 0]%float);
(2, [0; 0; 0; 0x3a773241833a9p-453; 0x7f1a354f2921dp-452; 0x1p-400; 0x1p-400; 0x1p-400]%float, 3, 2, 0xc08d602113efp-450%float, []%float, [0x80525f9bde457p-52; 0x1ee38e7be8c71fp-54; 0x83ecce8fd3c25p-57; -0x1a003f39accbe9p349; 0xb418477cf22afp350; 0xdf4d9283a1a2bp347; 0x1512d6eedfc1d9p751; -0x107150e6125623p752; 0x179f95ba89d4dbp750]%float);
(2, [0; 0; 0; 0x3a773241833a9p-453; 0x7f1a354f2921dp-452; 0x1p-400; 0x1p-400; 0x1p-400]%float, 3, 1, 0xd782a732f4fd7p-453%float, []%float, [0x1ed0238a549fe1p-58; 0x16259e38469ee1p-53; 0x11c7c156cd783fp-54; -0xcbdb811029393p348; -0x103e22e1d7ab29p348; 0x73ef6bcb68fafp350]%float);
(2, [0; 0; 0; 0x3a773241833a9p-453; 0x7f1a354f2921dp-452; 0x1p-400; 0x1p-400; 0x1p-400]%float, 4, 1, 0x7f1a354f2921dp-452%float, []%float, [0x2460e4aad3507p-50; 0x1b9f1b552caf9p-50; 0; -0x90802890d7531p350; 0x90802890d7531p350; 0]%float);
(2, [0; 0; 0; 0x3a773241833a9p-453; 0x7f1a354f2921dp-452; 0x1p-400; 0x1p-400; 0x1p-400]%float, 4, 3, 0x1fc68d53ca4875p-454%float, []%float, [0x2460e4aad3507p-50; 0x1b9f1b552caf93p-54; 0x1f8e4d2fcc754dp-159; -0x90802890d7531p350; 0x121005121aea61p349; 0x1f8e4d2fcc754dp296; 0x8f7e8ceebee65p751; -0x18bf0f66d2290bp751; 0x1f8e4d2fcc754dp750; 0; 0; 0]%float);
(2, [0; 0; 0; 0x3a773241833a9p-453; 0x7f1a354f2921dp-452; 0x1p-400; 0x1p-400; 0x1p-400]%float, 4, 2, 0x1fffffffffffffp-453%float, []%float, [0x8f7e8ceebee65p-156; 0xfe379df0735abp-103; 0x7ffffffffffffp-51; -0x8f7e8ceebee65p298; -0x7f1bcef839ad5p351; 0x1fc6f3be0e6b55p349; 0x8f7e8ceebee65p751; -0x18bf0f66d2290bp751; 0x1f8e4d2fcc754dp750]%float);
(2, [0; 0; 0; 0x3a773241833a9p-453; 0x7f1a354f2921dp-452; 0x1p-400; 0x1p-400; 0x1p-400]%float, 4, 1, 1%float, []%float, [0; 0; 1; 0; -0x1fc6f3be0e6b57p349; 0x1fc6f3be0e6b57p349]%float);
(2, [-0x17e3abbc6695fbp-53; -0x8a297c9f5a429p-53; -0x5f47af94f207p-52; 0xb7407d2d12983p-51; 0x7dcbcaecd85e5p-50; 0x7e6f77a82aa2bp-50]%float, 2, 3, -0xdf8eaef19a57fp-51%float, []%float, [0x1b5ccb932ef8c9p-53; 0x94668d9a20e7p-50; 0; -0x967487261f45dp-51; 0x967487261f45dp-51; 0; 0x19da56204feee3p-53; -0x17fc445901e80dp-52; 0x161e3291b3e137p-53; 0; 0; 0]%float);
(2, [-0x17e3abbc6695fbp-53; -0x8a297c9f5a429p-53; -0x5f47af94f207p-52; 0xb7407d2d12983p-51; 0x7dcbcaecd85e5p-50; 0x7e6f77a82aa2bp-50]%float, 2, 1, -0x17d1ebe53c81c1p-58%float, []%float, [0x1b5ccb932ef8c9p-53; 0x94668d9a20e7p-50; 0; -0x967487261f45dp-51; 0x967487261f45dp-51; 0]%float);
(2, [-0x17e3abbc6695fbp-53; -0x8a297c9f5a429p-53; -0x5f47af94f207p-52; 0xb7407d2d12983p-51; 0x7dcbcaecd85e5p-50; 0x7e6f77a82aa2bp-50]%float, 2, 2, -0x5f47af94f207p-52%float, []%float, [0x1b5ccb932ef8c9p-53; 0x94668d9a20e7p-50; 0; -0x967487261f45dp-51; 0x967487261f45dp-51; 0; 0x19da56204feee3p-53; -0x17fc445901e80dp-52; 0x161e3291b3e137p-53]%float);
(2, [-0x17e3abbc6695fbp-53; -0x8a297c9f5a429p-53; -0x5f47af94f207p-52; 0xb7407d2d12983p-51; 0x7dcbcaecd85e5p-50; 0x7e6f77a82aa2bp-50]%float, 2, 1, 0x184c489b695485p-55%float, []%float, [0x13ef2fb5f52a93p-53; 0x172085c737ce31p-54; 0x1011accdddcaa9p-58; -0x100d6a911762f1p-52; 0x1b6446c805a0b1p-53; 0x4b68e5a292531p-53]%float);
(2, [-0x17e3abbc6695fbp-53; -0x8a297c9f5a429p-53; -0x5f47af94f207p-52; 0xb7407d2d12983p-51; 0x7dcbcaecd85e5p-50; 0x7e6f77a82aa2bp-50]%float, 2, 3, 0x105c817b2c1aa5p-52%float, []%float, [0x114e07347eb723p-56; 0x8decdb855360bp-52; 0x183147518b7a09p-54; -0x1526bd9d5e6c5dp-54; -0x191cd59101f491p-54; 0x1721c997303077p-53; 0xced2b1027f771p-52; -0x5ff1116407a03p-50; 0x161e3291b3e137p-53; 0; 0; 0]%float);
(2, [-0x17e3abbc6695fbp-53; -0x8a297c9f5a429p-53; -0x5f47af94f207p-52; 0xb7407d2d12983p-51; 0x7dcbcaecd85e5p-50; 0x7e6f77a82aa2bp-50]%float, 2, 3, 0x16e80fa5a25307p-52%float, []%float, [0; 0x112e596e5d8c1fp-54; 0x1768d348d139f1p-53; 0; -0x101703b5ec771p-48; 0x101703b5ec771p-48; 0x19da56204feee3p-53; -0x17fc445901e80dp-52; 0x161e3291b3e137p-53; 0; 0; 0]%float);
(2, [-0x17e3abbc6695fbp-53; -0x8a297c9f5a429p-53; -0x5f47af94f207p-52; 0xb7407d2d12983p-51; 0x7dcbcaecd85e5p-50; 0x7e6f77a82aa2bp-50]%float, 2, 1, 0xbe6f77a82aa2bp-50%float, []%float, [0; 0x112e596e5d8c1fp-54; 0x1768d348d139f1p-53; 0; -0x101703b5ec771p-48; 0x101703b5ec771p-48]%float);
(3, [0; 0; 0; 0; 0x1p-28; 1; 1; 1; 1]%float, 3, 2, -1%float, []%float, [1; 0; 0; 0; -0x3p28; 0x3p28; 0; 0; 0x3p57; -0x30000003p29; 0x3p29; 0]%float);
(3, [0; 0; 0; 0; 0x1p-28; 1; 1; 1; 1]%float, 4, 1, 0xda73d6a2dc667p-53%float, []%float, [0x607e2d5472af1p-53; 0x1aed95a7dc528dp-54; 0xa05099b9d14dfp-53; 0x4f891765b2dd3p-54; -0x1f8e7354242847p-53; -0x3da4d62da50a1p-51; 0xebee28913afdp-48; 0x1179e3cd660b2bp-53]%float);
(3, [0; 0; 0; 0; 0x1p-28; 1; 1; 1; 1]%float, 4, 3, 0xd50e00870f273p-52%float, []%float, [0x13563fd6599713p-60; 0x11fcb9cd24b819p-56; 0x164f17b7c7cd6dp-54; 0x24e460d5959e3p-50; -0x159ce5c568daadp-56; -0x181aa972856ec9p-53; -0x9ebf5bd456c8fp-51; 0x109f8748120f17p-51; 0x101abfce5bfd4bp-52; 0x17d7e04cf52e11p-51; -0x11f5f8147ce085p-49; 0x13f9500ee82aafp-50; -0x30000003p-27; 0x24000003p-25; -0x48000009p-26; 0x30000009p-27]%float);
(3, [0; 0; 0; 0; 0x1p-28; 1; 1; 1; 1]%float, 4, 1, 0x1fffffffffffffp-53%float, []%float, [0x10000001p-187; 0x30000003p-134; 0x180000017fffffp-104; 0x1fffffffffffffp-53; -0x30000003p-134; -0x30000003p-80; -0x180000017ffffdp-51; 0xc000000bfffffp-50]%float);
(3, [0; 0; 0; 0; 0x1p-28; 1; 1; 1; 1]%float, 4, 3, 1%float, []%float, [0; 0; 0; 1; 0; 0; -0x30000003p-28; 0x30000003p-28; 0; 0x30000003p-27; -0x60000009p-27; 0x18000003p-26; -0x30000003p-27; 0x24000003p-25; -0x48000009p-26; 0x30000009p-27]%float);
(3, [0; 0; 0; 0; 0x1p-28; 1; 1; 1; 1]%float, 4, 1, 0x10000000000001p-52%float, []%float, [0; 0; 0; 1; 0; 0; -0x30000003p-28; 0x30000003p-28]%float);
(3, [0; 0; 0; 0; 0x1p-28; 1; 1; 1; 1]%float, 4, 2, 2%float, []%float, [0; 0; 0; 1; 0; 0; -0x30000003p-28; 0x30000003p-28; 0; 0x30000003p-27; -0x60000009p-27; 0x18000003p-26]%float);
(3, [0; 0; 0; 0; 0x1e6d528ce48d6fp-54; 0x1e6d528ce48d7p-50; 0x1e6d528ce48d71p-54; 0xf36a9467246b9p-53; 1; 1; 1; 1]%float, 3, 2, -1%float, []%float, [1; 0; 0; 0; -0xc9ecf763411e9p-49; 0xc9ecf763411e9p-49; 0; 0; 0xd45d4a6e8dc3bp-47; -0xd45d4a6e8dc3bp-46; 0xd45d4a6e8dc3bp-47; 0]%float);
(3, [0; 0; 0; 0; 0x1e6d528ce48d6fp-54; 0x1e6d528ce48d7p-50; 0x1e6d528ce48d71p-54; 0xf36a9467246b9p-53; 1; 1; 1; 1]%float, 3, 3, 0x1e19152f3266bp-53%float, []%float, [0xac4bce226581bp-52; 0x123b842be7153p-50; 0x149479b7869c9dp-57; 0x1ef9148eb6d093p-62; -0x9b13d03eb938bp-49; 0x1bd43f316e1531p-51; 0x5158ff9af3c3fp-50; 0xc594eae1c07dp-51; 0x174363eed1c71p-44; -0xacfa09fa8e72fp-46; 0x10b2d930d1e445p-48; 0x6908abdffe2cbp-49; -0xdf57c38d0583dp-46; 0x14f03a5538845bp-45; -0x14f03a55388459p-45; 0x1beaf871a0b077p-47]%float);
(3, [0; 0; 0; 0; 0x1e6d528ce48d6fp-54; 0x1e6d528ce48d7p-50; 0x1e6d528ce48d71p-54; 0xf36a9467246b9p-53; 1; 1; 1; 1]%float, 3, 1, 0x4c7170840599p-48%float, []%float, [0x695b276279195p-55; 0x42b8b9a23995p-48; 0x3856dfd16bcddp-51; 0x7edc439d3f587p-53; -0x6fb8c73f03a91p-51; -0x109a09b8cdad6fp-51; 0x756f5e93785dbp-52; 0x13ea1b38222513p-51]%float);
(3, [0; 0; 0; 0; 0x1e6d528ce48d6fp-54; 0x1e6d528ce48d7p-50; 0x1e6d528ce48d71p-54; 0xf36a9467246b9p-53; 1; 1; 1; 1]%float, 7, 2, 0xf36a9467246b9p-53%float, []%float, [0x7ffffffffffffp-51; 0x16e0243ad029c5p-104; 0x7449705712ae1p-157; 0; -0x16e0243ad029c5p-50; 0x5b8090eb40a71p-48; 0x15cdc5105380a3p-103; 0; 0x15cdc5105380a3p-48; -0x15cdc5105380a3p-47; 0x15cdc5105380a3p-48; 0]%float);
(3, [0; 0; 0; 0; 0x1e6d528ce48d6fp-54; 0x1e6d528ce48d7p-50; 0x1e6d528ce48d71p-54; 0xf36a9467246b9p-53; 1; 1; 1; 1]%float, 7, 2, 0x1fffffffffffffp-53%float, []%float, [0xddad5d3c3b789p-208; 0x15cdc5105380a5p-155; 0xb70121d6814e3p-102; 0xffffffffffffdp-52; -0xa64205ed2c9a7p-153; -0x573714414e029p-99; -0xb70121d6814e1p-49; 0x16e0243ad029c5p-50; 0xa64205ed2c9a7p-99; 0xae6e28829c051p-47; -0x573714414e029p-45; 0x573714414e029p-46]%float);
(3, [0; 0; 0; 0; 0x1e6d528ce48d6fp-54; 0x1e6d528ce48d7p-50; 0x1e6d528ce48d71p-54; 0xf36a9467246b9p-53; 1; 1; 1; 1]%float, 7, 3, 1%float, []%float, [0; 0; 0; 1; 0; 0; -0x2dc04875a0539p-47; 0x2dc04875a0539p-47; 0; 0x573714414e029p-46; -0x15cdc5105380a5p-47; 0xae6e28829c053p-47; -0x532102f6964d3p-45; 0x7cb18471e173dp-44; -0x7cb18471e173dp-44; 0xa64205ed2c9a7p-46]%float);
(3, [0; 0; 0; 0; 0x1e6d528ce48d6fp-54; 0x1e6d528ce48d7p-50; 0x1e6d528ce48d71p-54; 0xf36a9467246b9p-53; 1; 1; 1; 1]%float, 7, 2, 2%float, []%float, [0; 0; 0; 1; 0; 0; -0x2dc04875a0539p-47; 0x2dc04875a0539p-47; 0; 0x573714414e029p-46; -0x15cdc5105380a5p-47; 0xae6e28829c053p-47]%float);
(3, [0; 0; 0; 0; 0x199d19e9c07687p-53; 0x199d19e9c07687p-53; 1; 1; 1; 1]%float, 3, 2, -1%float, []%float, [1; 0; 0; 0; -0x77ef98c69a08dp-49; 0x77ef98c69a08dp-49; 0; 0; 0x4aeb805f019bp-43; -0x4aeb805f019bp-42; 0x4aeb805f019bp-43; 0]%float);
(3, [0; 0; 0; 0; 0x199d19e9c07687p-53; 0x199d19e9c07687p-53; 1; 1; 1; 1]%float, 3, 3, -0x1p-1074%float, []%float, [1; 0; 0; 0; -0x77ef98c69a08dp-49; 0x77ef98c69a08dp-49; 0; 0; 0x4aeb805f019bp-43; -0x4aeb805f019bp-42; 0x4aeb805f019bp-43; 0; -0x176664d4a3edp-41; 0x118ccb9f7af1bfp-47; -0x1061ea7042103p-43; 0x4aeb805f019bp-43]%float);
(3, [0; 0; 0; 0; 0x199d19e9c07687p-53; 0x199d19e9c07687p-53; 1; 1; 1; 1]%float, 3, 2, 0%float, []%float, [1; 0; 0; 0; -0x77ef98c69a08dp-49; 0x77ef98c69a08dp-49; 0; 0; 0x4aeb805f019bp-43; -0x4aeb805f019bp-42; 0x4aeb805f019bp-43; 0]%float);
(3, [0; 0; 0; 0; 0x199d19e9c07687p-53; 0x199d19e9c07687p-53; 1; 1; 1; 1]%float, 3, 3, 0x9883b3af9b1bfp-53%float, []%float, [0xfd6f3a4dd4d93p-54; 0x1c2a9714b8c01bp-54; 0x8ad4417be8d13p-53; 0xa8fb45bb360adp-56; -0x5e8e5fe4fc0d9p-50; -0x23138c4da246dp-51; 0xab018e115f9a3p-51; 0x1a975f031d63ddp-54; 0xbc2753f807ddfp-49; -0x4231fe9b044b7p-47; -0x329060b9206f3p-51; 0x16512fa8945ae7p-51; -0x176664d4a3edp-41; 0x118ccb9f7af1bfp-47; -0x1061ea7042103p-43; 0x4aeb805f019bp-43]%float);
(3, [0; 0; 0; 0; 0x199d19e9c07687p-53; 0x199d19e9c07687p-53; 1; 1; 1; 1]%float, 5, 1, 0x333a33d380ed1p-50%float, []%float, [0x198b9858fe25d9p-55; 0x199d19e9c0768bp-53; 0x12d494b79a5203p-152; 0x1f7381e6ee50ffp-205; -0x17fffffffffff9p-51; 0x5fffffffffff5p-49; 0x96a4a5bcd2901p-97; 0x5e5a85b4caf3p-144]%float);
(3, [0; 0; 0; 0; 0x199d19e9c07687p-53; 0x199d19e9c07687p-53; 1; 1; 1; 1]%float, 5, 1, 0x1d598223c1d4d3p-53%float, []%float, [0x74db30144c31dp-57; 0x5c064f5d92a83p-52; 0x3689642d235d9p-51; 0x19a00763c21d93p-55; -0x4222d68b96573p-51; -0xd907aba26345p-45; 0x113c9e7ba8fb39p-51; 0xa49de756a4edfp-49]%float);
(3, [0; 0; 0; 0; 0x199d19e9c07687p-53; 0x199d19e9c07687p-53; 1; 1; 1; 1]%float, 5, 1, 2%float, []%float, [0; 0; 0; 1; 0; 0; -0xf08393b8ea527p-48; 0xf08393b8ea527p-48]%float);
(3, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; 0x7acbf6cc2d8fp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 3, 3, -0x9333333333333p-50%float, []%float, [1; 0; 0; 0; -0x1f2c10411b768fp-52; 0x1f2c10411b768fp-52; 0; 0; 0x143e681c95ac91p-51; -0x1cab2e3c04e15dp-51; 0x21b3187dbcd33p-49; 0; -0x692c6fbbed4cdp-50; 0xa728ef604ae11p-50; -0x5033cb269a221p-50; 0x48dd2e08f2375p-52]%float);
(3, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; 0x7acbf6cc2d8fp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 3, 3, -0xa666666666667p-51%float, []%float, [1; 0; 0; 0; -0x1f2c10411b768fp-52; 0x1f2c10411b768fp-52; 0; 0; 0x143e681c95ac91p-51; -0x1cab2e3c04e15dp-51; 0x21b3187dbcd33p-49; 0; -0x692c6fbbed4cdp-50; 0xa728ef604ae11p-50; -0x5033cb269a221p-50; 0x48dd2e08f2375p-52]%float);
(3, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; 0x7acbf6cc2d8fp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 3, 2, -0x5333333333333p-50%float, []%float, [0x7ffffffffffffp-51; 0xf9608208dbb47p-103; 0x10d98c3ede6999p-157; 0x1849ba02fb67c7p-213; -0xf9608208dbb47p-51; 0x7cb041046dda3p-50; 0x10d98c3ede6999p-104; 0x12374b823c8dd5p-159; 0x143e681c95ac9p-47; -0x72acb8f013857p-49; 0x10d98c3ede6997p-52; 0x48dd2e08f2375p-104]%float);
(3, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; 0x7acbf6cc2d8fp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 4, 3, 0x7acbf6cc2d8fp-49%float, []%float, [0xae84861b472fbp-53; 0x1f19bc802434cbp-54; 0x58ad95e39729fp-53; 0; -0x792f072de1f35p-52; 0x459984802ddb3p-53; 0xacc489db960b7p-53; 0; 0x1c0cb742029e31p-54; -0x1c0cb742029e31p-53; 0x1c0cb742029e31p-54; 0; -0x33f09eef0f399p-52; 0x181b04abadc9dp-49; -0x1254927d4b531fp-52; 0x9861a166561cfp-52]%float);
(3, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; 0x7acbf6cc2d8fp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 4, 2, 0xc64fbaf4d7173p-52%float, []%float, [0x1295b44e9be0fp-51; 0xe7ad308b5752dp-53; 0x18c6db46d2fec3p-54; 0xf8a48074266dp-54; -0x1126cadb0d652dp-54; -0x1cd0e8a17a10bp-51; 0x1a1c82eed0801p-50; 0x15caf0f3e7b5d5p-56; 0x546b9bbae5bc3p-52; -0x1e50b44be8eab7p-54; -0x1653e595ab005p-51; 0xa2fe014027de9p-53]%float);
(3, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; 0x7acbf6cc2d8fp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 4, 1, 0x1d8d1a05e16dd7p-52%float, []%float, [0x176dffc652d58bp-60; 0x17f411461d3a37p-56; 0xfa53a3f5f5187p-53; 0xd2d6798506189p-53; -0xfe2fb48abe15p-53; -0x99957512678cbp-53; -0x380679359a26dp-51; 0x6264954c5f025p-51]%float);
(3, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; 0x7acbf6cc2d8fp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 4, 3, 0x6cccccccccccdp-49%float, []%float, [0; 0; 0; 1; 0; 0; -0x2c70ebd3e7bf3p-49; 0x2c70ebd3e7bf3p-49; 0; 0x1805afe82a3dd3p-53; -0x8256292617f37p-50; 0x1492b25570ddf1p-52; -0x33f09eef0f399p-52; 0x181b04abadc9dp-49; -0x1254927d4b531fp-52; 0x9861a166561cfp-52]%float);
(3, [0; 0; 0; 0; 0x57d116b4fc877p-453; 0x123fbd09d7e9b7p-453; 0x1a38a3f0dedp-441; 0x3d94b40734dd7p-450; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 3, 3, -1%float, []%float, [1; 0; 0; 0; -0x8bed808f52277p353; 0x8bed808f52277p353; 0; 0; 0x197e9750f9b6dbp755; -0x42530bc88eb0bp758; 0x1eabba4d3685f3p753; 0; neg_infinity; infinity; neg_infinity; infinity]%float);
(3, [0; 0; 0; 0; 0x57d116b4fc877p-453; 0x123fbd09d7e9b7p-453; 0x1a38a3f0dedp-441; 0x3d94b40734dd7p-450; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 3, 3, 0x1329281830a43p-453%float, []%float, [0x1e954d306ba3a5p-54; 0xf76c0fb216697p-53; 0x1393d0a24d0217p-57; 0x2adb141fbba19p-60; -0xab0e172bd8725p352; 0x45c4cbb57fe45p353; 0x7ab7202c0ff13p350; 0x1ad6f6ba95ac7p347; 0x4fba352169073p757; -0xcb6306381419bp756; 0xa485ac662c6a5p754; 0x166986ddb785e5p749; neg_infinity; infinity; neg_infinity; infinity]%float);
(3, [0; 0; 0; 0; 0x57d116b4fc877p-453; 0x123fbd09d7e9b7p-453; 0x1a38a3f0dedp-441; 0x3d94b40734dd7p-450; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 4, 1, 0x669bce56341d9p-453%float, []%float, [0x18f8b86cc2dd53p-54; 0x10516a523f1ee1p-53; 0x198a0f52cae647p-56; 0x1ef1a0c2b585afp-66; -0x32a2a9912d9f9p352; 0x1b7c8a6709167bp348; 0x16f3ea3757b473p348; 0x6469e599a9427p343]%float);
(3, [0; 0; 0; 0; 0x57d116b4fc877p-453; 0x123fbd09d7e9b7p-453; 0x1a38a3f0dedp-441; 0x3d94b40734dd7p-450; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 6, 3, 0x1eca5a039a6eb7p-453%float, []%float, [0xb4ccfef93ee27p-206; 0x96d3b188f59cdp-57; 0x16cf491af0b443p-54; 0x140187c0feb041p-53; -0x8799bf3aef29dp249; -0x17615fab675347p348; -0xbac91b19219f9p352; 0x1a454f58911e5bp351; 0x8799bf3aef29dp703; 0x13545f776ca13fp754; -0x4153721816095p758; 0x2dff12a0a9681p758; neg_infinity; infinity; neg_infinity; infinity]%float);
(3, [0; 0; 0; 0; 0x57d116b4fc877p-453; 0x123fbd09d7e9b7p-453; 0x1a38a3f0dedp-441; 0x3d94b40734dd7p-450; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 7, 1, 0x1eca5a039a6eb9p-453%float, []%float, [0x12da76311eb33dp-58; 0x5b3d246bc2d05p-52; 0x140187c0feb05bp-53; 0x12152c3c5b8dbp-193; -0xbb0afd5b3a97dp349; -0xbac91b1921a09p352; 0xd22a7ac488f39p352; 0x363f84b512a91p260]%float);
(3, [0; 0; 0; 0; 0x57d116b4fc877p-453; 0x123fbd09d7e9b7p-453; 0x1a38a3f0dedp-441; 0x3d94b40734dd7p-450; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 7, 3, 0x1p-400%float, []%float, [0; 0; 0; 1; 0; 0; -0x13d7842ae8c379p354; 0x13d7842ae8c379p354; 0; 0x1b77feb7d89f0bp757; -0x4f59d6f711057p762; 0x419dd79b24b5fp762; neg_infinity; infinity; neg_infinity; infinity]%float);
(3, [0; 0; 0; 0; 0x57d116b4fc877p-453; 0x123fbd09d7e9b7p-453; 0x1a38a3f0dedp-441; 0x3d94b40734dd7p-450; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 7, 1, 1%float, []%float, [0; 0; 0; 1; 0; 0; -0x13d7842ae8c379p354; 0x13d7842ae8c379p354]%float);
(3, [-0x19c9c7b207d535p-53; -0x196a6651b4db2bp-53; -0x122545c9a26599p-53; -0x29b55aa1a7aabp-51; 0x8d5dc5df01dbfp-51; 0x52f2dacc08697p-50; 0xbff971a04673bp-51; 0x6a9f0c531ed81p-50]%float, 3, 1, -0xe7271ec81f54dp-51%float, []%float, [0xa5046a6458b23p-52; 0xac667a79d24dp-49; 0x4c8585ebe275p-52; 0; -0x15a1fd7d29fe7p-48; 0x11ea3da0503a9p-48; 0xedeff73670f7dp-54; 0]%float);
(3, [-0x19c9c7b207d535p-53; -0x196a6651b4db2bp-53; -0x122545c9a26599p-53; -0x29b55aa1a7aabp-51; 0x8d5dc5df01dbfp-51; 0x52f2dacc08697p-50; 0xbff971a04673bp-51; 0x6a9f0c531ed81p-50]%float, 3, 3, -0x4ccac696999c5p-52%float, []%float, [0x1387156e5c2313p-53; 0xba96502340a45p-53; 0x19ef9f544814f7p-58; 0x22533648027ffp-67; -0xa6db3e9307f47p-51; 0x105b2ff1c13b97p-52; 0x11f919df77527p-50; 0x7c5a307b96b59p-62; 0xed9ee27396f6bp-51; -0x1db2cf8e0eb73fp-51; 0x1d1b97fbebc147p-52; 0x962ad1bece63fp-56; -0x152656987ebd85p-52; 0x20751402a9579p-47; -0x109baf5143187p-46; 0x16aaebd8387025p-52]%float);
(3, [-0x19c9c7b207d535p-53; -0x196a6651b4db2bp-53; -0x122545c9a26599p-53; -0x29b55aa1a7aabp-51; 0x8d5dc5df01dbfp-51; 0x52f2dacc08697p-50; 0xbff971a04673bp-51; 0x6a9f0c531ed81p-50]%float, 3, 3, -0x13bfcd4068ff1p-53%float, []%float, [0x150e01c0b76ccfp-54; 0x108a6475c59a95p-53; 0x4c0bf00350643p-53; 0x2ddba9a9a8bffp-57; -0x6e8613411a59fp-51; 0x61878bf34fef1p-53; 0x13aa26fc372f7bp-53; 0x1dee514da680f7p-57; 0xc1649379d16c9p-51; -0xa9b6c7ded6f3fp-50; 0x5df0bec5af649p-51; 0xd060f5f8b45b5p-53; -0x152656987ebd85p-52; 0x20751402a9579p-47; -0x109baf5143187p-46; 0x16aaebd8387025p-52]%float);
(3, [-0x19c9c7b207d535p-53; -0x196a6651b4db2bp-53; -0x122545c9a26599p-53; -0x29b55aa1a7aabp-51; 0x8d5dc5df01dbfp-51; 0x52f2dacc08697p-50; 0xbff971a04673bp-51; 0x6a9f0c531ed81p-50]%float, 3, 1, 0x11abb8bbe03b7dp-52%float, []%float, [0x1c331e20a8fcbp-207; 0x18e47fc2c56edfp-59; 0x1301cb011f9013p-54; 0x161b888065223bp-53; -0x54995a61faf61p-155; -0xc2d478e16492dp-54; -0x509082c9cf851p-50; 0x172f7295f9738fp-52]%float);
(3, [-0x19c9c7b207d535p-53; -0x196a6651b4db2bp-53; -0x122545c9a26599p-53; -0x29b55aa1a7aabp-51; 0x8d5dc5df01dbfp-51; 0x52f2dacc08697p-50; 0xbff971a04673bp-51; 0x6a9f0c531ed81p-50]%float, 3, 2, 0x8d5dc5df01dbfp-51%float, []%float, [0; 0x31c8ff858add9p-56; 0x980e5808fc807p-53; 0x161b888065223dp-53; 0; -0x30b51e3859249p-52; -0x142420b273e147p-52; 0x172f7295f9739p-48; 0; 0x1fc4ce74c1da27p-52; -0x80611d88d1149p-49; 0x1035e027d3581p-47]%float);
(3, [-0x19c9c7b207d535p-53; -0x196a6651b4db2bp-53; -0x122545c9a26599p-53; -0x29b55aa1a7aabp-51; 0x8d5dc5df01dbfp-51; 0x52f2dacc08697p-50; 0xbff971a04673bp-51; 0x6a9f0c531ed81p-50]%float, 3, 2, 0x11abb8bbe03b7fp-52%float, []%float, [0; 0x31c8ff858add9p-56; 0x980e5808fc807p-53; 0x161b888065223dp-53; 0; -0x30b51e3859249p-52; -0x142420b273e147p-52; 0x172f7295f9739p-48; 0; 0x1fc4ce74c1da27p-52; -0x80611d88d1149p-49; 0x1035e027d3581p-47]%float);
(3, [-0x19c9c7b207d535p-53; -0x196a6651b4db2bp-53; -0x122545c9a26599p-53; -0x29b55aa1a7aabp-51; 0x8d5dc5df01dbfp-51; 0x52f2dacc08697p-50; 0xbff971a04673bp-51; 0x6a9f0c531ed81p-50]%float, 3, 1, 0xaa9f0c531ed81p-50%float, []%float, [0; 0x31c8ff858add9p-56; 0x980e5808fc807p-53; 0x161b888065223dp-53; 0; -0x30b51e3859249p-52; -0x142420b273e147p-52; 0x172f7295f9739p-48]%float);
(4, [0; 0; 0; 0; 0; 0x1p-51; 0x1p-36; 1; 1; 1; 1; 1]%float, 4, 2, -1%float, []%float, [1; 0; 0; 0; 0; -0x1p53; 0x1p53; 0; 0; 0; 0x3p104; -0x18003p89; 0x3p89; 0; 0]%float);
(4, [0; 0; 0; 0; 0; 0x1p-51; 0x1p-36; 1; 1; 1; 1; 1]%float, 5, 2, 0x1p-51%float, []%float, [0x1fff40017fffp-45; 0x17ffd0001ffffdp-66; 0xbfff7ffffffffp-116; 0x1p-117; 0; -0x3fff0001p8; 0x3fff0000fffffp-12; 0x7fff7ffffffffp-63; 0x1p-64; 0; 0x17ffdp59; -0x17ffd000017ffdp23; 0xbffe7fffffffdp-12; 0x3p-13; 0]%float);
(4, [0; 0; 0; 0; 0; 0x1p-51; 0x1p-36; 1; 1; 1; 1; 1]%float, 5, 2, 0x1fffffffffffffp-89%float, []%float, [0x200040008001p-257; 0x1ffffffffa0005p-53; 0xbfff7fffe8003p-86; 0x2fffa0003d001p-120; 0x1fff40017fff09p-161; -0x200040008001p-166; -0x1ffffffffc0005p-51; 0x1ffffffff80009p-51; 0x7fff7ffff4003p-84; 0xfffc000400005p-122; 0x6000c0018003p-77; 0x2ffffffff0fffp-46; -0x17fffffffdc005p-48; 0xbfffffffdc005p-48; 0x2fffa00000001p-82]%float);
(4, [0; 0; 0; 0; 0; 0x1p-51; 0x1p-36; 1; 1; 1; 1; 1]%float, 6, 3, 0x6d123dd10eeabp-53%float, []%float, [0x188c3ead58cf71p-54; 0xd4a3ddbf2bb1dp-53; 0x1595d791ef39edp-55; 0x1f29ba879ae357p-58; 0x437c52a0de52dp-59; -0x1f315d9b528f31p-52; 0x5dc8aecea9fe9p-52; 0x1279680b911d4bp-52; 0x63d058f68188bp-52; 0x13cca26dd72e37p-57; 0x1dba3ae01863fdp-50; -0x56b8ae2f22fd9p-47; -0x90b7f3bb716abp-55; 0x1779a3741c75fp-47; 0x116d33ba44c44fp-53; -0x4b8c9468d1ecdp-46; 0xce3251a3466c1p-46; -0x14a96f4e9cce01p-47; 0x38c9468d001fbp-48; 0x51cdae5cc7a37p-48]%float);
(4, [0; 0; 0; 0; 0; 0x1p-51; 0x1p-36; 1; 1; 1; 1; 1]%float, 6, 3, 0x56548b318ae01p-51%float, []%float, [0xb804f9797c719p-58; 0x17d3f1542ff215p-56; 0x25064548a9d7bp-51; 0x66466dbce6b3fp-52; 0xd3e409debee37p-54; -0x235440ebc7e73p-52; -0xb840a833709d1p-52; -0x75abba9d130dp-47; 0x8cc1e6bdaa05p-48; 0x4e8a9de6ed265p-50; 0xa2c8d5f149379p-51; 0xae77cdcb053abp-50; -0xf3c1eb34d580dp-50; -0xb4ba9f6d06799p-49; 0x2bab5e296713bp-47; -0xfa04bcd6ce601p-49; 0x3a04bcd6c6481p-47; 0xc8f8e4bdeacfdp-47; -0x517ed0ca588bfp-45; 0x817ed0ca64afdp-47]%float);
(4, [0; 0; 0; 0; 0; 0x1p-51; 0x1p-36; 1; 1; 1; 1; 1]%float, 6, 3, 0x10000000000001p-52%float, []%float, [0; 0; 0; 0; 1; 0; 0; 0; -0x1000000001p-34; 0x1000000001p-34; 0; 0; 0x18000000018003p-49; -0xc000000012001p-47; 0x1800000003p-33; 0; -0x18000000018003p-48; 0x12000000018003p-46; -0x9000000012001p-45; 0x3000000009p-33]%float);
(4, [0; 0; 0; 0; 0; 0x1p-51; 0x1p-36; 1; 1; 1; 1; 1]%float, 6, 2, 2%float, []%float, [0; 0; 0; 0; 1; 0; 0; 0; -0x1000000001p-34; 0x1000000001p-34; 0; 0; 0x18000000018003p-49; -0xc000000012001p-47; 0x1800000003p-33]%float);
(4, [0; 0; 0; 0; 0; 0x2dd47ad230c5p-46; 0x16ea3d69186281p-53; 0x16ea3d69186281p-53; 1; 1; 1; 1; 1]%float, 4, 1, -1%float, []%float, [1; 0; 0; 0; 0; -0x1657ebeb6d60d1p-50; 0x1657ebeb6d60d1p-50; 0; 0; 0]%float);
(4, [0; 0; 0; 0; 0; 0x2dd47ad230c5p-46; 0x16ea3d69186281p-53; 0x16ea3d69186281p-53; 1; 1; 1; 1; 1]%float, 4, 2, 0x1p-1074%float, []%float, [1; 0x1p-1072; 0; 0; 0; -0x1657ebeb6d60d1p-50; 0x1657ebeb6d60d1p-50; 0x1p-1070; 0; 0; 0x5d9b03bfeb12dp-46; -0x1766c0effac4b3p-47; 0x1766c0effac4b3p-48; 0x3p-1070; 0]%float);
(4, [0; 0; 0; 0; 0; 0x2dd47ad230c5p-46; 0x16ea3d69186281p-53; 0x16ea3d69186281p-53; 1; 1; 1; 1; 1]%float, 4, 2, 0xad6cd4220d67p-51%float, []%float, [0x4d5f5416e5a9p-47; 0x14c0ceaae13773p-54; 0x42cc4a2d8d44fp-54; 0xc0eea74e80cabp-59; 0x92d4caf7d79e5p-64; -0x1ea27486d31a2dp-51; 0x124f2639d3a8f9p-51; 0x1558482d5b6fd5p-52; 0xcccf2826caeabp-54; 0x6c5f30211ba03p-58; 0x918d6c3802cabp-47; -0xfc106cef618a7p-47; 0x4616c4fdea051p-47; 0x1146288e7fc543p-50; 0xeff54e3a981c7p-54]%float);
(4, [0; 0; 0; 0; 0; 0x2dd47ad230c5p-46; 0x16ea3d69186281p-53; 0x16ea3d69186281p-53; 1; 1; 1; 1; 1]%float, 4, 1, 0x16ea3d6918627fp-53%float, []%float, [0xf3638431a5581p-262; 0xa3656552fb2a7p-205; 0x424dcd529bd7fp-151; 0x48ae14b73cec3p-52; 0xb751eb48c313dp-52; -0x1e6c708634ab03p-208; -0x9880c4f81d9f1p-151; -0x13804b72a64e91p-100; -0x1fffffffffffefp-51; 0x1ffffffffffff9p-51]%float);
(4, [0; 0; 0; 0; 0; 0x2dd47ad230c5p-46; 0x16ea3d69186281p-53; 0x16ea3d69186281p-53; 1; 1; 1; 1; 1]%float, 7, 1, 0x5cdc0b10a57afp-51%float, []%float, [0x7f18ca347f51p-49; 0x17db391308aab9p-53; 0x32140cd388a4fp-57; 0x123bf7b067490dp-65; 0x13eb0688f6457fp-72; -0x1cef4146630d3bp-51; 0x93fb32475f393p-50; 0x14294c9fa2d631p-52; 0x168ac038da4de9p-57; 0x109acc251c5245p-63]%float);
(4, [0; 0; 0; 0; 0; 0x2dd47ad230c5p-46; 0x16ea3d69186281p-53; 0x16ea3d69186281p-53; 1; 1; 1; 1; 1]%float, 7, 3, 1%float, []%float, [0; 0; 0; 0; 1; 0; 0; 0; -0x1c2da6050f1fe9p-49; 0x1c2da6050f1fe9p-49; 0; 0; 0x129c1abd5c8527p-45; -0x129c1abd5c8527p-44; 0x129c1abd5c8527p-45; 0; -0x106323780724d3p-42; 0x6252d4d02addp-35; -0x1894b5340ab741p-41; 0x83191bc03926bp-41]%float);
(4, [0; 0; 0; 0; 0; 0x2dd47ad230c5p-46; 0x16ea3d69186281p-53; 0x16ea3d69186281p-53; 1; 1; 1; 1; 1]%float, 7, 3, 2%float, []%float, [0; 0; 0; 0; 1; 0; 0; 0; -0x1c2da6050f1fe9p-49; 0x1c2da6050f1fe9p-49; 0; 0; 0x129c1abd5c8527p-45; -0x129c1abd5c8527p-44; 0x129c1abd5c8527p-45; 0; -0x106323780724d3p-42; 0x6252d4d02addp-35; -0x1894b5340ab741p-41; 0x83191bc03926bp-41]%float);
(4, [0; 0; 0; 0; 0; 0x1ddae00ba91ffp-51; 0x1ddae00ba91ffp-51; 1; 1; 1; 1; 1]%float, 4, 2, -1%float, []%float, [1; 0; 0; 0; 0; -0x4499281804fa5p-46; 0x4499281804fa5p-46; 0; 0; 0; 0x1b9295649073abp-45; -0x1b9295649073abp-44; 0x1b9295649073abp-45; 0; 0]%float);
(4, [0; 0; 0; 0; 0; 0x1ddae00ba91ffp-51; 0x1ddae00ba91ffp-51; 1; 1; 1; 1; 1]%float, 4, 3, 0x1ddae00ba91fefp-55%float, []%float, [0x151e34f17450fp-260; 0x13b3d19ea2eabdp-209; 0x9681c7654c87p-48; 0x16e43c41b09c91p-54; 0x1bda8f27e20d77p-57; -0x151e34f17450efp-207; -0x1d8dba6df4601bp-153; -0x188947fd15b805p-51; 0x88947fd15b805p-50; 0xeed7005d48ff7p-52; 0xfd6a7b5173cb3p-150; 0x3b1b74dbe8c03p-94; 0xbffffffffffedp-48; -0x5ffffffffffffp-46; 0x17ffffffffffffp-49; -0xfd6a7b5173cb3p-94; -0x1d8dba6df46017p-42; 0x1306fb5bd44d7p-37; -0x50de99d222c53p-41; 0x66e5bc2407777p-44]%float);
(4, [0; 0; 0; 0; 0; 0x1ddae00ba91ffp-51; 0x1ddae00ba91ffp-51; 1; 1; 1; 1; 1]%float, 6, 1, 0x1ddae00ba91ffp-51%float, []%float, [0x9681c7654c87p-48; 0x16e43c41b09c91p-54; 0xded4793f106bdp-56; 0; 0; -0x62251ff456e01p-49; 0x22251ff456e01p-48; 0x1ddae00ba91ffp-49; 0; 0]%float);
(4, [0; 0; 0; 0; 0; 0x1ddae00ba91ffp-51; 0x1ddae00ba91ffp-51; 1; 1; 1; 1; 1]%float, 6, 1, 0x82b588178f14dp-53%float, []%float, [0x10bdacd08b848fp-53; 0xcc54b1f34371dp-53; 0x13e2271c172c51p-56; 0x60decf71d2923p-64; 0xb78f3d92aa051p-72; -0x59eb55958e939p-49; 0xd0999a50fa333p-51; 0x12aefb60493281p-52; 0x65f418b804a23p-57; 0x10428059d2068bp-65]%float);
(4, [0; 0; 0; 0; 0; 0x1ddae00ba91ffp-51; 0x1ddae00ba91ffp-51; 1; 1; 1; 1; 1]%float, 6, 1, 0x8181e85aea8e1p-52%float, []%float, [0xcfa41d9bf9c3fp-55; 0x5a811ce0c52f9p-52; 0x1a71e5c5e25395p-54; 0x1dab0f790655e9p-56; 0x417b8db2bf3bbp-56; -0x690ecc0514df1p-51; -0x266d9231d91f3p-49; 0xbf17bab7f5957p-52; 0x10a67496964f89p-52; 0x1e0592bbcc14d1p-55]%float);
(4, [0; 0; 0; 0; 0; 0x1ddae00ba91ffp-51; 0x1ddae00ba91ffp-51; 1; 1; 1; 1; 1]%float, 6, 3, 0x10000000000001p-52%float, []%float, [0; 0; 0; 0; 1; 0; 0; 0; -0x14ddf8fb587c6dp-50; 0x14ddf8fb587c6dp-50; 0; 0; 0x146938753759f9p-48; -0x146938753759f9p-47; 0x146938753759f9p-48; 0; -0x146938753759f9p-47; 0x1269a6e44144fbp-45; -0x4fdc14a9b496fp-43; 0x1a9eb18de6dcfbp-47]%float);
(4, [0; 0; 0; 0; 0; 0x1ddae00ba91ffp-51; 0x1ddae00ba91ffp-51; 1; 1; 1; 1; 1]%float, 6, 1, 2%float, []%float, [0; 0; 0; 0; 1; 0; 0; 0; -0x14ddf8fb587c6dp-50; 0x14ddf8fb587c6dp-50]%float);
(4, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x1c7afe1bad419p-51; -0xa7b58e8e9a77p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 4, 2, -0x9333333333333p-50%float, []%float, [1; 0; 0; 0; 0; -0xed9677bfb7333p-50; 0xed9677bfb7333p-50; 0; 0; 0; 0x14abfeb3e48d4fp-49; -0x132e6f8d22274bp-48; 0x2361c0ccbf829p-46; 0; 0]%float);
(4, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x1c7afe1bad419p-51; -0xa7b58e8e9a77p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 4, 1, -0x5333333333333p-50%float, []%float, [0xffffffffffffdp-52; 0xed9677bfb7331p-102; 0x8d870332fe0a3p-153; 0x660071022819dp-207; 0xdc8b5535186f3p-264; -0x1db2cef7f6e661p-51; 0x1db2cef7f6e65dp-51; 0x8d870332fe0a3p-100; 0x9900a9833c26bp-154; 0x1b916aa6a30de5p-211]%float);
(4, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x1c7afe1bad419p-51; -0xa7b58e8e9a77p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 4, 1, -0x1c7afe1bad4191p-55%float, []%float, [0x17bd8505310c81p-273; 0x62420497d4981p-59; 0x112056711f3b87p-53; 0xc748bea798d31p-53; 0x2528d23414225p-53; -0x2f7b0a0a6219p-209; -0x21d30bdf1cddp-49; -0x5c8ed59d38771p-51; 0x850ded5ba1883p-52; 0x113e50f397751bp-54]%float);
(4, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x1c7afe1bad419p-51; -0xa7b58e8e9a77p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 5, 2, -0x1d0224de90eafp-52%float, []%float, [0x13d7cc2940ca8bp-66; 0x7487d67dcf581p-52; 0xe048ba951cd71p-53; 0x1b4bfe05e81c1fp-56; 0x16c1f57e810fd1p-67; -0x11230adeaca99dp-60; -0x5bf13857351d1p-51; 0x1773aca326dde7p-54; 0xb57b7134b6e73p-53; 0x1a0d8d578660b9p-62; 0x58cc91c3eefcdp-53; 0x13442307aceacbp-53; -0x650f47a65b8c3p-50; 0x1850d01fafe2abp-53; 0xb2f3c7c90468fp-56]%float);
(4, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x1c7afe1bad419p-51; -0xa7b58e8e9a77p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 6, 3, 0x1a2a4deabba93p-51%float, []%float, [0x10f8876f7672e5p-54; 0xf64c5d776a51p-49; 0x1f5c6bbe1c4b43p-55; 0x4705678597165p-57; 0x1ac3382ef2c625p-66; -0x1eeb080c76392bp-54; -0x3fc7cd3762ea3p-54; 0xf2073392dfd3bp-53; 0x122d66a7d23bedp-56; 0x1b44c39bde5d4dp-62; 0xa8fbbbbe4d345p-52; -0x41bef649e0d8bp-50; -0xde205aff42fa7p-57; 0x17eedef72232cbp-54; 0xa6b48c94ef61fp-57; -0x99ee2131cfcfp-48; 0x1f2f5d78b8baf5p-52; -0x8fc7ce439ffd3p-50; 0x1774146e62f57p-49; 0xa9db7d06b1a39p-54]%float);
(4, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x1c7afe1bad419p-51; -0xa7b58e8e9a77p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 6, 3, 0x4cccccccccccdp-49%float, []%float, [0; 0; 0; 0; 1; 0; 0; 0; -0x1a3827d0d081ebp-52; 0x1a3827d0d081ebp-52; 0; 0; 0x77f959a48050bp-50; -0x1f1be5a3b7737dp-51; 0x101cba6f276967p-51; 0; -0x103673e5cc2693p-52; 0xfea5dec4f2b7bp-50; -0x49da3f64e37b7p-48; 0xd339dccb97a0dp-51]%float);
(4, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x1c7afe1bad419p-51; -0xa7b58e8e9a77p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 6, 3, 0x6cccccccccccdp-49%float, []%float, [0; 0; 0; 0; 1; 0; 0; 0; -0x1a3827d0d081ebp-52; 0x1a3827d0d081ebp-52; 0; 0; 0x77f959a48050bp-50; -0x1f1be5a3b7737dp-51; 0x101cba6f276967p-51; 0; -0x103673e5cc2693p-52; 0xfea5dec4f2b7bp-50; -0x49da3f64e37b7p-48; 0xd339dccb97a0dp-51]%float);
(4, [0; 0; 0; 0; 0; 0x64e0fff25b75p-447; 0x1a831ef4800485p-453; 0x1bb7a6b3f705e1p-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 4, 1, -1%float, []%float, [1; 0; 0; 0; 0; -0xa2699cb30629fp351; 0xa2699cb30629fp351; 0; 0; 0]%float);
(4, [0; 0; 0; 0; 0; 0x64e0fff25b75p-447; 0x1a831ef4800485p-453; 0x1bb7a6b3f705e1p-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 4, 1, -0x1p-1074%float, []%float, [1; 0; 0; 0; 0; -0xa2699cb30629fp351; 0xa2699cb30629fp351; 0; 0; 0]%float);
(4, [0; 0; 0; 0; 0; 0x64e0fff25b75p-447; 0x1a831ef4800485p-453; 0x1bb7a6b3f705e1p-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 4, 2, 0x96605d99055abp-452%float, []%float, [0x113aa3e5674551p-60; 0x1f239a9d23b52bp-57; 0x880c4b04cbb7bp-53; 0xeae0ecfef0545p-53; 0xd78fb1c4e6ac3p-54; -0xabaeb37ae794bp345; -0x17121141cae8c7p347; -0x14fede2d48fbd7p348; 0xaefbd8c09e141p348; 0x16ef86a91a5e23p348; 0x140c4a7d3de313p748; 0x12a9117cd72b0bp750; -0x222256a5299bfp753; -0x11f1db1f899951p751; 0xea45ebac0ae67p751]%float);
(4, [0; 0; 0; 0; 0; 0x64e0fff25b75p-447; 0x1a831ef4800485p-453; 0x1bb7a6b3f705e1p-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 6, 1, 0x1a831ef4800485p-453%float, []%float, [0x77938b08bb3e7p-61; 0x15e4ea67c413f3p-55; 0x19e54356459767p-53; 0x9a08d718d7e75p-57; 0; -0x6337a1a7c675bp346; -0x1b659f3b1bb1dfp349; 0x6a32a72d1ea65p350; 0x772dccc63b5p358; 0]%float);
(4, [0; 0; 0; 0; 0; 0x64e0fff25b75p-447; 0x1a831ef4800485p-453; 0x1bb7a6b3f705e1p-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 7, 2, 0xed192dac18e69p-452%float, []%float, [0x190829d3f0929dp-60; 0xdbfb9c5fc45a7p-54; 0x1c662c43807d7dp-54; 0x12e034e21fccafp-54; 0xa5711b44eb787p-56; -0x15306d751f27dfp346; -0x1c9de6c62738bbp350; -0xa3c54e0f0f9ebp350; 0x759f0c57009bdp352; 0x158afed153fc61p349; 0x1ae78fd51dd365p751; 0x6c7d83bb84c6fp756; -0x1ebef244b1b9a7p755; -0x15403dc5683b7p755; 0x21a999588b8e9p758]%float);
(4, [0; 0; 0; 0; 0; 0x64e0fff25b75p-447; 0x1a831ef4800485p-453; 0x1bb7a6b3f705e1p-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 7, 2, 0x10000000000001p-452%float, []%float, [0; 0; 0; 0; 1; 0; 0; 0; -0x1de3677d4e1bf7p352; 0x1de3677d4e1bf7p352; 0; 0; 0x415b0eef37419p759; -0x4a8d40dca0abfp760; 0xa77ee594142c9p758]%float);
(4, [0; 0; 0; 0; 0; 0x64e0fff25b75p-447; 0x1a831ef4800485p-453; 0x1bb7a6b3f705e1p-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 7, 3, 1%float, []%float, [0; 0; 0; 0; 1; 0; 0; 0; -0x1de3677d4e1bf7p352; 0x1de3677d4e1bf7p352; 0; 0; 0x415b0eef37419p759; -0x4a8d40dca0abfp760; 0xa77ee594142c9p758; nan; nan; nan; nan; infinity]%float);
(4, [-0xeb12dfa18732fp-52; -0xc6baacade39a3p-52; -0xbbb7ffd452ce7p-52; -0xdbc2861cc84c7p-53; -0x37ed3d6d15aa9p-53; 0xa37ab991b943dp-51; 0x5d4c176f2c903p-50; 0xc83fcb388c781p-51; 0x1c979cb0176cc5p-52; 0x7b344d10ea1e9p-50]%float, 4, 3, -0x1eb12dfa18732fp-52%float, []%float, [0x306b85d6b5ec3p-51; 0x7946f66da91cfp-52; 0x2493827cab499p-52; 0x14e7b683fc11e5p-60; 0; -0x11765a1a70d007p-52; 0x2c60aadd6a83dp-51; 0xae4f18847c171p-52; 0x4154cd9eef87p-50; 0; 0x12e498a8f96001p-51; -0x101f6be61f61e9p-50; 0x112277e53d80e1p-52; 0x13240cc29a8d81p-53; 0; -0x1b4120d11ca613p-51; 0x1400c3b93f1e3p-45; -0xa555282965689p-48; 0xef453006970dp-46; 0]%float);
(4, [-0xeb12dfa18732fp-52; -0xc6baacade39a3p-52; -0xbbb7ffd452ce7p-52; -0xdbc2861cc84c7p-53; -0x37ed3d6d15aa9p-53; 0xa37ab991b943dp-51; 0x5d4c176f2c903p-50; 0xc83fcb388c781p-51; 0x1c979cb0176cc5p-52; 0x7b344d10ea1e9p-50]%float, 4, 2, -0x1bf69eb68ad549p-56%float, []%float, [0x306b85d6b5ec3p-51; 0x7946f66da91cfp-52; 0x2493827cab499p-52; 0x14e7b683fc11e5p-60; 0; -0x11765a1a70d007p-52; 0x2c60aadd6a83dp-51; 0xae4f18847c171p-52; 0x4154cd9eef87p-50; 0; 0x12e498a8f96001p-51; -0x101f6be61f61e9p-50; 0x112277e53d80e1p-52; 0x13240cc29a8d81p-53; 0]%float);
(4, [-0xeb12dfa18732fp-52; -0xc6baacade39a3p-52; -0xbbb7ffd452ce7p-52; -0xdbc2861cc84c7p-53; -0x37ed3d6d15aa9p-53; 0xa37ab991b943dp-51; 0x5d4c176f2c903p-50; 0xc83fcb388c781p-51; 0x1c979cb0176cc5p-52; 0x7b344d10ea1e9p-50]%float, 4, 3, -0x1bf69eb68ad547p-56%float, []%float, [0x306b85d6b5ec3p-51; 0x7946f66da91cfp-52; 0x2493827cab499p-52; 0x14e7b683fc11e5p-60; 0x12907bb929f7a7p-279; -0x11765a1a70d007p-52; 0x2c60aadd6a83dp-51; 0xae4f18847c171p-52; 0x4154cd9eef87p-50; 0x12907bb929f7a7p-221; 0x12e498a8f96001p-51; -0x101f6be61f61e9p-50; 0x112277e53d80e1p-52; 0x13240cc29a8d81p-53; 0xdec5ccadf79bdp-163; -0x1b4120d11ca613p-51; 0x1400c3b93f1e3p-45; -0xa555282965689p-48; 0xef453006970dp-46; 0xdec5ccadf79bdp-106]%float);
(4, [-0xeb12dfa18732fp-52; -0xc6baacade39a3p-52; -0xbbb7ffd452ce7p-52; -0xdbc2861cc84c7p-53; -0x37ed3d6d15aa9p-53; 0xa37ab991b943dp-51; 0x5d4c176f2c903p-50; 0xc83fcb388c781p-51; 0x1c979cb0176cc5p-52; 0x7b344d10ea1e9p-50]%float, 4, 3, 0x124edc19963ebp-54%float, []%float, [0x41eb05f3ced09p-52; 0x1f4499d36d5211p-54; 0x1e0b3882617d03p-55; 0x9d34d0568a3a5p-57; 0x13d9b824db727bp-67; -0xd1611e559702bp-52; -0x2d2c6ecc54ea1p-53; 0x17a713b06b4d75p-53; 0xa9c28b9403cfdp-54; 0x4e155366181a9p-60; 0x7cb310e90caafp-50; -0x5adb2497ccbf9p-49; -0x1c3c195182d53fp-56; 0xf916194e98681p-52; 0x1ccb847476f825p-58; -0x6305c5ee2c0afp-49; 0x22fac4ce1f9dfp-46; -0x10811da05f667fp-49; 0x8a31d8341ee27p-50; 0xe288d69161229p-53]%float);
(4, [-0xeb12dfa18732fp-52; -0xc6baacade39a3p-52; -0xbbb7ffd452ce7p-52; -0xdbc2861cc84c7p-53; -0x37ed3d6d15aa9p-53; 0xa37ab991b943dp-51; 0x5d4c176f2c903p-50; 0xc83fcb388c781p-51; 0x1c979cb0176cc5p-52; 0x7b344d10ea1e9p-50]%float, 4, 1, 0x338e677c72f19p-54%float, []%float, [0x1db067a1f94a0dp-55; 0x7bf7d175e31dbp-52; 0x8468d32b70b81p-53; 0x66ccbb4ffcc39p-56; 0x18a7edc897e17bp-66; -0xc1990ff8e9bfbp-52; -0x5a0ad7dc66ec9p-53; 0xbb36f9a226be1p-52; 0x1966806ac49bfp-51; 0x13502deda800afp-61]%float);
(4, [-0xeb12dfa18732fp-52; -0xc6baacade39a3p-52; -0xbbb7ffd452ce7p-52; -0xdbc2861cc84c7p-53; -0x37ed3d6d15aa9p-53; 0xa37ab991b943dp-51; 0x5d4c176f2c903p-50; 0xc83fcb388c781p-51; 0x1c979cb0176cc5p-52; 0x7b344d10ea1e9p-50]%float, 4, 2, 0xa37ab991b943dp-51%float, []%float, [0; 0x1dc94815ad095dp-63; 0x181293e1d8841p-53; 0xd51b59dd511dfp-53; 0x1125aed207fa9fp-53; 0; -0x149e22ff64ea65p-58; -0x7e5ed48618379p-52; -0x21080d98d73edp-49; 0xc5e3650655b45p-51; 0; 0xab419fa944167p-53; 0x9eb49652b7583p-50; -0x628da4fb1d54bp-48; 0xd619c9a49577dp-50]%float);
(4, [-0xeb12dfa18732fp-52; -0xc6baacade39a3p-52; -0xbbb7ffd452ce7p-52; -0xdbc2861cc84c7p-53; -0x37ed3d6d15aa9p-53; 0xa37ab991b943dp-51; 0x5d4c176f2c903p-50; 0xc83fcb388c781p-51; 0x1c979cb0176cc5p-52; 0x7b344d10ea1e9p-50]%float, 4, 2, 0xbb344d10ea1e9p-50%float, []%float, [0; 0x1dc94815ad095dp-63; 0x181293e1d8841p-53; 0xd51b59dd511dfp-53; 0x1125aed207fa9fp-53; 0; -0x149e22ff64ea65p-58; -0x7e5ed48618379p-52; -0x21080d98d73edp-49; 0xc5e3650655b45p-51; 0; 0xab419fa944167p-53; 0x9eb49652b7583p-50; -0x628da4fb1d54bp-48; 0xd619c9a49577dp-50]%float);
(5, [0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1]%float, 5, 1, -1%float, []%float, [1; 0; 0; 0; 0; 0; -5; 5; 0; 0; 0; 0]%float);
(5, [0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1]%float, 5, 2, -0x1p-1074%float, []%float, [1; 0; 0; 0; 0; 0; -5; 5; 0; 0; 0; 0; 20; -40; 20; 0; 0; 0]%float);
(5, [0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1]%float, 5, 1, 0%float, []%float, [1; 0; 0; 0; 0; 0; -5; 5; 0; 0; 0; 0]%float);
(5, [0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1]%float, 5, 1, 0x297a21c3b2a71p-52%float, []%float, [0xd38ffeeb63edbp-53; 0x1990c016f874b3p-54; 0x9e2cc5a86f455p-54; 0xf4a8d109ddfe1p-57; 0x17a6e452096f4dp-61; 0xea232e2534117p-65; -0x2772afda85ba5p-48; 0x47844cb24e5b9p-51; 0xad487e363f551p-51; 0x3da8ff1e309bp-47; 0x115d9cf918f22dp-56; 0x70e650e30dce9p-59]%float);
(5, [0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1]%float, 5, 2, 0xe6dd7e8ab669p-49%float, []%float, [0x66395b7a31cb9p-55; 0x347744592f7d9p-52; 0x2b15a0ed18b63p-51; 0x11b0b688b83e89p-54; 0x3a1bbe7f89553p-53; 0x131653eaccdf83p-58; -0x1d16c76163a733p-54; -0x109d8779392323p-52; -0x1625afb7859925p-54; 0xd50d22b26294fp-52; 0xccd3691f8fdcbp-52; 0xd3a720951307fp-54; 0xd3e802cbd6d09p-50; 0xc477a86d8d27dp-51; -0xc9be50f0eb445p-49; -0x6d0097ccc4017p-49; 0x18401cc048e7afp-51; 0xeab228ecf3d35p-51]%float);
(5, [0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1]%float, 5, 1, 0x10000000000001p-52%float, []%float, [0; 0; 0; 0; 0; 1; 0; 0; 0; 0; -5; 5]%float);
(5, [0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1]%float, 5, 2, 2%float, []%float, [0; 0; 0; 0; 0; 1; 0; 0; 0; 0; -5; 5; 0; 0; 0; 20; -40; 20]%float);
(5, [0; 0; 0; 0; 0; 0; 0x15161352f9dcd1p-54; 1; 1; 1; 1; 1; 1]%float, 5, 3, -1%float, []%float, [1; 0; 0; 0; 0; 0; -0x3cb3ff61bfe7dp-46; 0x3cb3ff61bfe7dp-46; 0; 0; 0; 0; 0x1707ca07ebde41p-45; -0xf4f24fa11ed9dp-44; 0x3cb3ff61bfe7dp-44; 0; 0; 0; -0xd1b3ea7371117p-41; 0x12d8ec84fdca31p-41; -0x1ca7976844e227p-43; 0xb61bfe253fb77p-44; 0; 0]%float);
(5, [0; 0; 0; 0; 0; 0; 0x15161352f9dcd1p-54; 1; 1; 1; 1; 1; 1]%float, 5, 1, 0x4b4521319b501p-52%float, []%float, [0x1e3cbc4fab4e61p-69; 0x42f2b9a3e180fp-52; 0x1aa1c6a3dfa1f9p-54; 0xff28dca6475a3p-54; 0x882f5bc28a21dp-55; 0x1b51744da5f10dp-60; -0x10a8eb42dee823p-61; -0x1d96a578b1c265p-52; -0x14c9abe2e4ffefp-54; 0xa8a888a3a470bp-51; 0xbebc510b4b2e5p-52; 0xe84760f1986d3p-55]%float);
(5, [0; 0; 0; 0; 0; 0; 0x15161352f9dcd1p-54; 1; 1; 1; 1; 1; 1]%float, 5, 1, 0x15161352f9dcdp-50%float, []%float, [0x1019362ade3e9dp-314; 0xceff8c51035d3p-54; 0x196d8517cea2e7p-54; 0x12bdcdfd0d98ddp-54; 0x311d22f284d83p-53; 0xc10fc7c2f362fp-58; -0xa0fc1dacae723p-257; -0x181e308dc4d63p-48; -0xb6f1cf6b56213p-52; 0x121542ade62763p-52; 0x74dc9dfb39819p-51; 0x5b8ee2e59c15bp-53]%float);
(5, [0; 0; 0; 0; 0; 0; 0x15161352f9dcd1p-54; 1; 1; 1; 1; 1; 1]%float, 6, 1, 0x15161352f9dcd1p-54%float, []%float, [0x677fc62881ae9p-53; 0x196d8517cea2e9p-54; 0x95ee6fe86cc7p-49; 0x188e9179426c1dp-56; 0x6087e3e179b19p-57; 0; -0x181e308dc4d62fp-52; -0x16de39ed6ac42dp-53; 0x121542ade62763p-52; 0x3a6e4efd9cc0dp-50; 0x16e3b8b9670571p-55; 0]%float);
(5, [0; 0; 0; 0; 0; 0; 0x15161352f9dcd1p-54; 1; 1; 1; 1; 1; 1]%float, 6, 1, 0xe8c2d21a2fec9p-52%float, []%float, [0x13479657e1b309p-69; 0xef0318c1f0befp-63; 0x24dbc18ba5c79p-56; 0x2d080f875b2b9p-53; 0x1ad748ece5b951p-54; 0x1eeca7740d8ad7p-54; -0x84bd6f9a67937p-62; -0x28003beda70cfp-55; -0x46602d9cba28bp-52; -0x330cbe64f8ef1p-49; -0x48dd491e94b3fp-49; 0x10ab46824b0afp-46]%float);
(5, [0; 0; 0; 0; 0; 0; 0x15161352f9dcd1p-54; 1; 1; 1; 1; 1; 1]%float, 6, 1, 0x10000000000001p-52%float, []%float, [0; 0; 0; 0; 0; 1; 0; 0; 0; 0; -0x1dd3c726b2ecadp-50; 0x1dd3c726b2ecadp-50]%float);
(5, [0; 0; 0; 0; 0; 0; 0x15161352f9dcd1p-54; 1; 1; 1; 1; 1; 1]%float, 6, 3, 2%float, []%float, [0; 0; 0; 0; 0; 1; 0; 0; 0; 0; -0x1dd3c726b2ecadp-50; 0x1dd3c726b2ecadp-50; 0; 0; 0; 0x1dd3c726b2ecadp-48; -0x1293df9897273p-42; 0x2c7bb73ba9b01p-44; 0; 0; -0xb2f6aae8318c1p-45; 0x4e1a7426cba71p-42; -0x1a5f4217447441p-44; 0x6382d32698b6fp-43]%float);
(5, [0; 0; 0; 0; 0; 0; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 1; 1; 1; 1; 1; 1]%float, 5, 1, -1%float, []%float, [1; 0; 0; 0; 0; 0; -0x1bc308285d3019p-48; 0x1bc308285d3019p-48; 0; 0; 0; 0]%float);
(5, [0; 0; 0; 0; 0; 0; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 1; 1; 1; 1; 1; 1]%float, 5, 1, -0x1p-1074%float, []%float, [1; 0; 0; 0; 0; 0; -0x1bc308285d3019p-48; 0x1bc308285d3019p-48; 0; 0; 0; 0]%float);
(5, [0; 0; 0; 0; 0; 0; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 1; 1; 1; 1; 1; 1]%float, 5, 2, 0%float, []%float, [1; 0; 0; 0; 0; 0; -0x1bc308285d3019p-48; 0x1bc308285d3019p-48; 0; 0; 0; 0; 0x9a24dc637b54fp-42; -0x9a24dc637b54fp-41; 0x9a24dc637b54fp-42; 0; 0; 0]%float);
(5, [0; 0; 0; 0; 0; 0; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 1; 1; 1; 1; 1; 1]%float, 5, 3, 0x1p-1074%float, []%float, [1; 0xfp-1073; 0; 0; 0; 0; -0x1bc308285d3019p-48; 0x1bc308285d3019p-48; 0x299p-1074; 0; 0; 0; 0x9a24dc637b54fp-42; -0x9a24dc637b54fp-41; 0x9a24dc637b54fp-42; 0xad7p-1072; 0; 0; -0x140f2f7afca68fp-39; 0xf0b639c3d7cebp-37; -0xf0b639c3d7cebp-37; 0x140f2f7afca68fp-39; 0x2067p-1072; 0]%float);
(5, [0; 0; 0; 0; 0; 0; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 1; 1; 1; 1; 1; 1]%float, 11, 2, 0xc96fa75f71533p-52%float, []%float, [0x12866bb6182bc5p-58; 0xb57999cdeadd5p-54; 0x8f973520aa651p-52; 0xbf1caf512de39p-54; 0xd2d727d6683dbp-56; 0x2e8565945b7d1p-57; -0x1b293485826a3dp-54; -0xa197975a6cb49p-50; -0xe80e779d7900dp-51; 0xc0b339e318961p-50; 0xc13febbcc402bp-51; 0x1ee9afda620fa7p-55; 0xfedd698cc21cdp-49; 0x10bf30130e32ddp-48; -0xf423c9e88d6e9p-46; -0x25656a34a558bp-52; 0xe206749403d77p-47; 0x106edbe4c6848fp-49]%float);
(5, [0; 0; 0; 0; 0; 0; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 1; 1; 1; 1; 1; 1]%float, 11, 1, 0x1d9e8b992ea49fp-53%float, []%float, [0x18924fc7476f1p-62; 0x8c4275671653dp-59; 0x98992906ee4d1p-55; 0xf141c560525e9p-54; 0xcfcc637d062e9p-53; 0x8f2f1c939511dp-53; -0x19cd93848ecbdp-56; -0x1bef951e762f0bp-55; -0x510e8b9798d69p-49; -0x3937dcb0d57c5p-48; 0xe0dde5a9918b3p-52; 0x574904595c239p-48]%float);
(5, [0; 0; 0; 0; 0; 0; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 1; 1; 1; 1; 1; 1]%float, 11, 2, 2%float, []%float, [0; 0; 0; 0; 0; 1; 0; 0; 0; 0; -0x78f3915e3da85p-47; 0x78f3915e3da85p-47; 0; 0; 0; 0x16dbb335754de5p-45; -0x16dbb335754de5p-44; 0x16dbb335754de5p-45]%float);
(5, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x21ffea554823fp-49; -0x1d753f0456a1fp-52; 0x12e7af9dbf08bp-51; 0xb2d885b76b8dp-50; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 5, 3, -0x9333333333333p-50%float, []%float, [1; 0; 0; 0; 0; 0; -0x5434f4fcaa69fp-46; 0x5434f4fcaa69fp-46; 0; 0; 0; 0; 0x1628a2fb67244bp-44; -0xd4cd65283f87p-39; 0x11c426a683325bp-46; 0; 0; 0; -0x117e33da14029p-36; 0x15b3bf200e48ffp-40; -0x9919e1ede5ce1p-41; 0x49a1e4ba73ffbp-43; 0; 0]%float);
(5, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x21ffea554823fp-49; -0x1d753f0456a1fp-52; 0x12e7af9dbf08bp-51; 0xb2d885b76b8dp-50; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 6, 2, -0xe3514f88cae55p-52%float, []%float, [0x12e6a41ec40d87p-55; 0x1af711229c28d9p-54; 0xa1d4f2e0ff1d1p-53; 0x1c16f0526a459bp-56; 0x15469b142c7313p-60; 0x9fc3daa636a19p-68; -0x1e9192f0c06127p-53; -0x165c830f130fcdp-53; 0x67726a364913dp-51; 0x191ef6ac9325a3p-53; 0xf82452cbd044bp-56; 0x478402ccba691p-62; 0x4f1a2f23a4b7fp-48; -0x10d8fd5c770bbbp-50; -0x81db9b040518dp-49; 0x164d83e6f38217p-51; 0x1105dfaaea6279p-53; 0x199c2cddce021p-56]%float);
(5, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x21ffea554823fp-49; -0x1d753f0456a1fp-52; 0x12e7af9dbf08bp-51; 0xb2d885b76b8dp-50; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 6, 2, -0x101f01832e1405p-53%float, []%float, [0x4dd9bd6c95ecbp-58; 0x186fbd9bccaacbp-56; 0x12ef146be853adp-54; 0x1036a66a8007c1p-53; 0x605628e4a76e7p-54; 0x1a398636b2a67fp-61; -0xfa58992ce6ce9p-56; -0x2631b1c2e7085p-50; -0x180273e137445fp-53; 0x1d802f4e60e355p-53; 0x7528ec0f0ec19p-52; 0x1d5624983b5381p-58; 0xa10248ca1d11fp-52; 0x4887a1c3ec977p-49; -0x3bd6c992a1ce3p-49; -0x149cfc391a07adp-51; 0xac4a36bcd7b03p-51; 0xd2083d5478e51p-54]%float);
(5, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x21ffea554823fp-49; -0x1d753f0456a1fp-52; 0x12e7af9dbf08bp-51; 0xb2d885b76b8dp-50; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 7, 1, -0x1d753f0456a1fp-52%float, []%float, [0x1545ac891d92bbp-62; 0xd60d077136765p-57; 0x126fd15c426521p-53; 0x167f9008563cf5p-54; 0xb7db60ee5b929p-56; 0; -0x65318d31f59b7p-56; -0x14cfd8a8a59519p-54; -0x50b96984a7fbp-47; 0x2f981c69d4f13p-50; 0x7949b9af63bebp-53; 0]%float);
(5, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x21ffea554823fp-49; -0x1d753f0456a1fp-52; 0x12e7af9dbf08bp-51; 0xb2d885b76b8dp-50; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 8, 2, 0x12e7af9dbf08b1p-55%float, []%float, [0x16bcf1bec98f49p-73; 0xb7c14769400f9p-53; 0x7dbfda0e664f5p-52; 0x130dd73b408591p-55; 0x10f219ffef9047p-62; 0x17101b7d7557a1p-327; -0x10793830aa054fp-65; -0xcbe913c53a4a1p-52; 0x6fbe6fbb16f2fp-53; 0x8f084ccdf8709p-52; 0xa13976b9d6a17p-57; 0x1cd4225cd2ad89p-270; 0x1318899787f893p-58; 0xb125a4af56da9p-51; -0xac45bbbb38ff9p-50; 0x3f54d72210635p-50; 0x99644d40257b7p-53; 0x1cd4225cd2ad89p-213]%float);
(5, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x21ffea554823fp-49; -0x1d753f0456a1fp-52; 0x12e7af9dbf08bp-51; 0xb2d885b76b8dp-50; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 8, 3, 0x165b10b6ed719fp-55%float, []%float, [0x17cb8a78194d4bp-322; 0xad04bea94dca7p-53; 0x3f813c84c678dp-51; 0x15065a8bf81b55p-55; 0x6e7231b499767p-60; 0x1609d64062ba33p-78; -0xedf368b0fd04fp-264; -0xc25f64a592ed9p-52; 0x12e71c5ab3dd67p-55; 0x12a42113fd9463p-53; 0x76fe37269b51bp-56; 0x7fbba9b52de0fp-69; 0xedf368b0fd04fp-207; 0xaeb0978a53c95p-51; -0x1446d70b07fd9fp-51; 0x18bd1022d92305p-53; 0x656c2cf840847p-52; 0x9410f53a1236dp-62; -0xb2768e84bdc3bp-150; -0x1d7001c043966fp-52; 0x19e75bc20c73d9p-50; -0x841718f819cd1p-48; 0x1c741bb369ec57p-51; 0x405d1255eedafp-54]%float);
(5, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x21ffea554823fp-49; -0x1d753f0456a1fp-52; 0x12e7af9dbf08bp-51; 0xb2d885b76b8dp-50; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 9, 3, 0x6cccccccccccdp-49%float, []%float, [0; 0; 0; 0; 0; 1; 0; 0; 0; 0; -0x8fcc41298af99p-50; 0x8fcc41298af99p-50; 0; 0; 0; 0x3fd8430749139p-48; -0x100ed0c157f0bp-45; 0x102790c0dd9c7bp-50; 0; 0; -0x4c2797b118d0fp-48; 0xf7436cfd17f3p-44; -0x811c450b3467p-43; 0xae396994d357bp-49]%float);
(5, [0; 0; 0; 0; 0; 0; 0x3c0592ea96dfbp-451; 0x6392decfade31p-451; 0x6f0df86b02d35p-451; 0x1c84c9922bf16fp-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 5, 3, -1%float, []%float, [1; 0; 0; 0; 0; 0; -0x554d68ad65e8bp353; 0x554d68ad65e8bp353; 0; 0; 0; 0; 0x16bd3255d3d425p754; -0x123911f35dcaf9p755; 0xdb4f190e7c1cdp754; 0; 0; 0; neg_infinity; nan; nan; nan; nan; nan]%float);
(5, [0; 0; 0; 0; 0; 0; 0x3c0592ea96dfbp-451; 0x6392decfade31p-451; 0x6f0df86b02d35p-451; 0x1c84c9922bf16fp-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 5, 1, 0x27564c632ffdp-447%float, []%float, [0x13e8d065568725p-60; 0x188a8c3fa8125p-51; 0xd08e02bce784fp-53; 0x4b146bfa07a07p-52; 0x2fa7f6447d921p-53; 0x13e78ffd0237dp-55; -0x4d006e45a7a75p347; -0x393b0f4b9d45bp351; -0xa1f7eed16b11fp348; 0x5a785517c1ec1p350; 0xfff46f1b5d3c9p348; 0x143d6e6b62131dp345]%float);
(5, [0; 0; 0; 0; 0; 0; 0x3c0592ea96dfbp-451; 0x6392decfade31p-451; 0x6f0df86b02d35p-451; 0x1c84c9922bf16fp-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 6, 2, 0x1e02c9754b6fd9p-454%float, []%float, [0x197dc7055df67p-54; 0x186375e6b610e3p-55; 0xc527a94200933p-53; 0x28d8f8986647dp-51; 0xa49ee4fb7c3b9p-55; 0x884d5f05cd8b3p-315; -0x671ed10608ba1p348; -0xc1a72dc202811p349; -0x10857d9de272b3p347; 0x1932ef4ef6a043p348; 0xdb6a2489b74d9p348; 0x55305b63a077p146; 0x14db931b612bd9p750; 0x3d4d556bcd393p752; -0xe3336687a8bc3p752; -0x8a0b18a325fd9p750; 0xe9f515ae40a5fp751; 0x55305b63a077p602]%float);
(5, [0; 0; 0; 0; 0; 0; 0x3c0592ea96dfbp-451; 0x6392decfade31p-451; 0x6f0df86b02d35p-451; 0x1c84c9922bf16fp-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 6, 1, 0x8aa67226a6999p-452%float, []%float, [0xd56b0ccab93f5p-59; 0x60f42e9d6397dp-54; 0x1416b7bfe8ff9p-50; 0xd6f74d66c9c15p-53; 0x151c44b0a30fedp-55; 0x121e5585518125p-65; -0x11a37fbd51b623p345; -0x115dbdb2d381f9p348; -0x15efac25b7db5fp348; 0x228cc3844a7dfp351; 0x605212cbce3fp354; 0x4de6b6398ac7dp343]%float);
(5, [0; 0; 0; 0; 0; 0; 0x3c0592ea96dfbp-451; 0x6392decfade31p-451; 0x6f0df86b02d35p-451; 0x1c84c9922bf16fp-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 6, 2, 0x18e4b7b3eb78c3p-453%float, []%float, [0x11ac87095dde91p-314; 0x104a37e1be8c95p-64; 0xbb3438471e8a5p-58; 0xc86cfa80efcb3p-54; 0x99c1df7fb80d3p-52; 0x1892e36386e3b1p-55; -0x1617a8cbb55635p141; -0x1c60a50faa2135p341; -0x194c4a4a686d11p346; -0xa41f2c7dc77cdp350; -0x220afded907f5p348; 0x31b44edb0456bp352; 0x1617a8cbb55635p596; 0x13c6175b550cedp747; 0x1230dca85dff81p751; 0x139afa258f2dd9p749; -0xd1830705a035bp754; 0xa0db0db6b1fe3p754]%float);
(5, [0; 0; 0; 0; 0; 0; 0x3c0592ea96dfbp-451; 0x6392decfade31p-451; 0x6f0df86b02d35p-451; 0x1c84c9922bf16fp-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 7, 3, 0x6392decfade31p-451%float, []%float, [0x104a37e1be8c77p-64; 0x17668708e3d12fp-59; 0xc86cfa80efcadp-54; 0x4ce0efbfdc069p-51; 0xc4971b1c371ddp-54; 0; -0xe305287d51085p342; -0xca6252534367fp347; -0x2907cb1f71df3p352; -0x11057ef6c8407p349; 0xc6d13b6c115bp354; 0; 0x9e30badaa866bp748; 0x1230dca85dff7bp751; 0x139afa258f2e3dp749; -0x1a3060e0b406bfp753; 0xa0db0db6b1fe5p754; 0; neg_infinity; nan; nan; nan; nan; nan]%float);
(5, [0; 0; 0; 0; 0; 0; 0x3c0592ea96dfbp-451; 0x6392decfade31p-451; 0x6f0df86b02d35p-451; 0x1c84c9922bf16fp-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 9, 2, 1%float, []%float, [0; 0; 0; 0; 0; 1; 0; 0; 0; 0; -0x2df5b8dfe8b67p356; 0x2df5b8dfe8b67p356; 0; 0; 0; 0xad9521a15d5dp763; -0x180d03770c12fp763; 0xd33b15cf63d1fp759]%float);
(5, [-0xe91c1c60882d9p-52; -0xe8d5bfeb22badp-52; -0x1527dd303cb017p-53; -0xd9edfad6d173bp-53; -0x3f289a91aac8fp-52; -0x2e15fbf703cb9p-52; 0xb88eaec535255p-53; 0x10a82668a78c3p-48; 0x4bf4bde288ac7p-50; 0x9d1c4d863f667p-51; 0x19439c75c978ddp-52; 0xe5783c5d8ddd3p-51; 0x7ddcbe3a744b5p-50]%float, 5, 3, -0x1e91c1c60882d9p-52%float, []%float, [0x11a3b28f04c2d5p-55; 0x9efe7223438f3p-52; 0x3af394009688fp-52; 0x162e5f20384431p-59; 0x191b42ab358aa9p-69; 0; -0xa32e601f8f091p-51; -0x81b4642052b55p-52; 0x321e259f4c8f9p-49; 0xdb94936bd2f1bp-54; 0x1d69450bc736f9p-63; 0; 0x12dea511185d8bp-49; -0x6b4b156a23e7dp-47; 0x1961b132a7e7d5p-53; 0x1909d41e50d799p-51; 0x6e40bac7a01b7p-55; 0; -0x1a2f3079f611d3p-47; 0x749addf35eedbp-44; -0x2c4b1c7a9cb15p-43; 0xaf6e421e7a7ffp-47; 0x135f9d8fba44a7p-51; 0]%float);
(5, [-0xe91c1c60882d9p-52; -0xe8d5bfeb22badp-52; -0x1527dd303cb017p-53; -0xd9edfad6d173bp-53; -0x3f289a91aac8fp-52; -0x2e15fbf703cb9p-52; 0xb88eaec535255p-53; 0x10a82668a78c3p-48; 0x4bf4bde288ac7p-50; 0x9d1c4d863f667p-51; 0x19439c75c978ddp-52; 0xe5783c5d8ddd3p-51; 0x7ddcbe3a744b5p-50]%float, 5, 1, -0x170afdfb81e5c9p-55%float, []%float, [0x11a3b28f04c2d5p-55; 0x9efe7223438f3p-52; 0x3af394009688fp-52; 0x162e5f20384431p-59; 0x191b42ab358aa9p-69; 0; -0xa32e601f8f091p-51; -0x81b4642052b55p-52; 0x321e259f4c8f9p-49; 0xdb94936bd2f1bp-54; 0x1d69450bc736f9p-63; 0]%float);
(5, [-0xe91c1c60882d9p-52; -0xe8d5bfeb22badp-52; -0x1527dd303cb017p-53; -0xd9edfad6d173bp-53; -0x3f289a91aac8fp-52; -0x2e15fbf703cb9p-52; 0xb88eaec535255p-53; 0x10a82668a78c3p-48; 0x4bf4bde288ac7p-50; 0x9d1c4d863f667p-51; 0x19439c75c978ddp-52; 0xe5783c5d8ddd3p-51; 0x7ddcbe3a744b5p-50]%float, 5, 1, -0x743db3e9d5aa3p-55%float, []%float, [0x26ae1159ec05bp-54; 0xfa226c815a41dp-53; 0x340d1285a0017p-51; 0x215821707fa53p-53; 0xf873bc5f1e465p-61; 0x1ab8e50f22f579p-69; -0x1cf8aaf1502fabp-54; -0xb5dbfe7d66cd5p-51; 0x1261fac949fb85p-52; 0x15bb197a696635p-53; 0x5c0286b8fdf59p-55; 0x10efc081d8567dp-63]%float);
(5, [-0xe91c1c60882d9p-52; -0xe8d5bfeb22badp-52; -0x1527dd303cb017p-53; -0xd9edfad6d173bp-53; -0x3f289a91aac8fp-52; -0x2e15fbf703cb9p-52; 0xb88eaec535255p-53; 0x10a82668a78c3p-48; 0x4bf4bde288ac7p-50; 0x9d1c4d863f667p-51; 0x19439c75c978ddp-52; 0xe5783c5d8ddd3p-51; 0x7ddcbe3a744b5p-50]%float, 6, 1, 0xb88eaec535255p-53%float, []%float, [0x6fee1bd6b6d1dp-55; 0x1474e7e034591bp-54; 0x1afacdfba0ab77p-54; 0xbbe79f5245d5p-50; 0x1525f5050e78a1p-58; 0; -0x19b26de9945051p-54; -0x424ff166ef425p-50; 0x13d6a76021a687p-54; 0x1df8bb1ccaf07dp-53; 0xc3a41b6cc0b23p-54; 0]%float);
(5, [-0xe91c1c60882d9p-52; -0xe8d5bfeb22badp-52; -0x1527dd303cb017p-53; -0xd9edfad6d173bp-53; -0x3f289a91aac8fp-52; -0x2e15fbf703cb9p-52; 0xb88eaec535255p-53; 0x10a82668a78c3p-48; 0x4bf4bde288ac7p-50; 0x9d1c4d863f667p-51; 0x19439c75c978ddp-52; 0xe5783c5d8ddd3p-51; 0x7ddcbe3a744b5p-50]%float, 6, 1, 0x1711d5d8a6a4abp-54%float, []%float, [0x1bfb86f5adb473p-57; 0xa3a73f01a2c8dp-53; 0x35f59bf74156fp-51; 0x5df3cfa922ea9p-53; 0xa92fa82873c53p-57; 0x12cd5566f7cdc7p-322; -0xcd936f4ca2827p-53; -0x424ff166ef425p-50; 0x13d6a76021a67dp-54; 0xefc5d8e65783fp-52; 0xc3a41b6cc0b25p-54; 0x1780aac0b5c139p-266]%float);
(5, [-0xe91c1c60882d9p-52; -0xe8d5bfeb22badp-52; -0x1527dd303cb017p-53; -0xd9edfad6d173bp-53; -0x3f289a91aac8fp-52; -0x2e15fbf703cb9p-52; 0xb88eaec535255p-53; 0x10a82668a78c3p-48; 0x4bf4bde288ac7p-50; 0x9d1c4d863f667p-51; 0x19439c75c978ddp-52; 0xe5783c5d8ddd3p-51; 0x7ddcbe3a744b5p-50]%float, 6, 1, 0x910843b0202ebp-52%float, []%float, [0x938820ca5ff07p-58; 0x411662bb444ffp-53; 0xbe9d73be259bfp-53; 0xc71d31994ae7fp-53; 0xd165eb9ed6287p-55; 0xe4effd0a8a54dp-63; -0x612897a46c87dp-54; -0xbdf7a7e808a9p-48; -0xb922ffc4d2b05p-52; 0x1c9171afa085bp-49; 0xa822e3f112805p-52; 0x15b2e13efe6b9fp-59]%float);
(5, [-0xe91c1c60882d9p-52; -0xe8d5bfeb22badp-52; -0x1527dd303cb017p-53; -0xd9edfad6d173bp-53; -0x3f289a91aac8fp-52; -0x2e15fbf703cb9p-52; 0xb88eaec535255p-53; 0x10a82668a78c3p-48; 0x4bf4bde288ac7p-50; 0x9d1c4d863f667p-51; 0x19439c75c978ddp-52; 0xe5783c5d8ddd3p-51; 0x7ddcbe3a744b5p-50]%float, 6, 3, 0xbddcbe3a744b5p-50%float, []%float, [0; 0x16a973f4465efbp-65; 0x1369739564f995p-59; 0x3ac3f5de55ac3p-52; 0x12dab7f4ec4f19p-53; 0x15f6e3a6d08c51p-55; 0; -0x184af1bc412057p-60; -0x33a16e7415025p-52; -0xb6e87587dabfbp-51; 0xc07a03e584a9dp-53; 0x142ba06accc3edp-52; 0; 0x29aa5e0f69265p-52; 0x17146514095f35p-51; 0x4825075c88dfdp-52; -0xabd1c10f99249p-48; 0x1da3002431d171p-50; 0; -0xd662fa5dabfd7p-50; -0x10ba0e108f49e1p-48; 0x85211a1434a17p-45; -0x13c96e859a1e5bp-46; 0x41518e0ca8451p-45]%float)]%nat.

Definition points : list (nat * list float * nat * nat * float * list float * list float) := [
(1, [0; 0; 0x1p-59; 0x1p-53; 0x1p-32; 0x1p-27; 1; 1]%float, 1, 0, -1%float, [0x91ee53da863d5p-48; 0x8f4e0719f6537p-48; -0x11bce9fb8ac57fp-49; -0x109ae92831d8b1p-49; 0x6b5c116ec36a9p-48; 0x4b82a9585bc57p-48]%float, [0x91ee53da863d5p-48]%float);
(1, [0; 0; 0x1p-59; 0x1p-53; 0x1p-32; 0x1p-27; 1; 1]%float, 1, 0, 0x1fffffffffffffp-112%float, [0x713a1ce453513p-48; -0x13df92f5f0c87p-46; -0xb82e11ef74b35p-49; -0x9490a270c0789p-48; 0x39ffaffe55d73p-48; 0x4ff47b5c9d075p-47]%float, [-0x9efc97af86437p-49]%float);
(1, [0; 0; 0x1p-59; 0x1p-53; 0x1p-32; 0x1p-27; 1; 1]%float, 3, 0, 0x10000000000001p-105%float, [0x184b26733ae93p-46; 0x1cd1cc99f2bcfp-46; 0xb9b3917e73dp-46; -0x51e1a42477411p-49; 0x8b6d8051cb4e9p-48; 0xa95a42bac9p-44]%float, [0xb9b3917e73dp-46]%float);
(1, [0; 0; 0x1p-59; 0x1p-53; 0x1p-32; 0x1p-27; 1; 1]%float, 5, 0, 0x48beab12cd75dp-52%float, [-0xae0fc0959df2bp-50; 0x8a30dea4bd153p-48; 0x827ae397335a5p-48; -0x30e39428a826fp-49; 0x7ae691bd07b55p-48; -0x1ad746ee6517fp-46]%float, [0x72f011dad3fb1p-49]%float);
(1, [0; 0; 0x1p-59; 0x1p-53; 0x1p-32; 0x1p-27; 1; 1]%float, 5, 0, 0x1f26838f87a893p-53%float, [-0xac6a0ece1763p-45; -0xcee632c5fd12bp-49; -0x1a1ce6fea20e01p-50; 0x340db0468b13p-48; -0x59cc29101af5fp-49; 0x4655e2afaac1p-48]%float, [0x62cadaec9a61fp-53]%float);
(1, [0; 0; 0x1p-59; 0x1p-53; 0x1p-32; 0x1p-27; 1; 1]%float, 5, 0, 1%float, [0x4f3a7a35df161p-47; -0x11655de8212dbp-48; -0x369c4de53f741p-49; 0x81df5a44384dp-48; 0x1056d0c6d07e5p-45; -0xadc0c001a3effp-50]%float, [-0xadc0c001a3effp-50]%float);
(1, [0; 0; 0x1p-59; 0x1p-53; 0x1p-32; 0x1p-27; 1; 1]%float, 5, 0, 2%float, [-0x5d938aa30c913p-49; 0x99e999d25bd1fp-48; 0x93ceecc1d4ac9p-48; -0xd8d781a39af85p-49; 0x28a401bbff4d1p-47; 0x44d9295d8b29fp-48]%float, [0x44d9295d8b29fp-48]%float);
(1, [0; 0; 0x158a064de1bf69p-53; 0xac50326f0dfb5p-52; 0x158a064de1bf6bp-53; 1; 1]%float, 1, 0, -1%float, [0x63249d5a6daf5p-49; -0x50080c146641fp-48; -0x11abfc6ec06e1p-46; -0x279eb6fdd8dp-46; 0x9d9dbe2859f1p-49]%float, [0x63249d5a6daf5p-49]%float);
(1, [0; 0; 0x158a064de1bf69p-53; 0xac50326f0dfb5p-52; 0x158a064de1bf6bp-53; 1; 1]%float, 1, 0, 0xbbf7a7a31f84dp-53%float, [0x33bd48cb5064bp-48; -0x1cffca080621dp-49; 0x81043b4270c3bp-48; -0xbf021c852accfp-50; 0x48488414d02fp-44]%float, [0xf9c70e71b1b3fp-52]%float);
(1, [0; 0; 0x158a064de1bf69p-53; 0xac50326f0dfb5p-52; 0x158a064de1bf6bp-53; 1; 1]%float, 1, 0, 0xaa2ca1a58946dp-52%float, [-0x8920deb4a077p-49; -0x59053df2604abp-48; -0xe06d099da68edp-50; 0x7fb9d132cd573p-49; -0xd5b72489dd433p-49]%float, [-0xafeff3c1c945p-45]%float);
(1, [0; 0; 0x158a064de1bf69p-53; 0xac50326f0dfb5p-52; 0x158a064de1bf6bp-53; 1; 1]%float, 2, 0, 0x158a064de1bf69p-53%float, [0x575ada9c74825p-48; -0x33cc751cf097p-47; -0xfbc7b906d277p-46; 0x2fe1a4c61fc61p-47; 0x34f889ee15c1p-43]%float, [-0x33cc751cf097p-47]%float);
(1, [0; 0; 0x158a064de1bf69p-53; 0xac50326f0dfb5p-52; 0x158a064de1bf6bp-53; 1; 1]%float, 3, 0, 0xac50326f0dfb5p-52%float, [-0x786b6d05868e7p-49; -0xbaff0568e3323p-49; 0x79c544d53ee9p-49; 0x4576f669af445p-47; 0x13b8f01da4323p-47]%float, [0x79c544d53ee9p-49]%float);
(1, [0; 0; 0x158a064de1bf69p-53; 0xac50326f0dfb5p-52; 0x158a064de1bf6bp-53; 1; 1]%float, 4, 0, 0x5628193786fdbp-51%float, [0x12137100158f5p-46; 0x104e5f821346bp-45; -0xc58093803c091p-49; 0x139526730fc3p-42; -0x11a64f1420bfb5p-49]%float, [0x139526730fc2fbp-50]%float);
(1, [0; 0; 0x158a064de1bf69p-53; 0xac50326f0dfb5p-52; 0x158a064de1bf6bp-53; 1; 1]%float, 4, 0, 2%float, [-0x244dd5c02a7e9p-47; -0xaef725d966db9p-49; 0x3c141e4e511b1p-47; -0x3eff5868e9a07p-47; 0x1c9fcc55d709p-46]%float, [0x1c9fcc55d709p-46]%float);
(1, [0; 0; 0xad3bf7c68cb73p-54; 0x1720cd30861a05p-53; 1; 1]%float, 1, 0, -1%float, [-0xa34eba8e052bdp-49; -0x1729642e906ec9p-50; 0x3ce4a0fd352b9p-47; -0xc554b0a0a679p-47]%float, [-0xa34eba8e052bdp-49]%float);
(1, [0; 0; 0xad3bf7c68cb73p-54; 0x1720cd30861a05p-53; 1; 1]%float, 1, 0, 0x1p-1074%float, [0x5302ca8146615p-48; -0x46e99e74c0bb9p-47; -0xb2eb9ba47fc13p-50; -0xa051a46a2dc39p-49]%float, [0x5302ca8146615p-48]%float);
(1, [0; 0; 0xad3bf7c68cb73p-54; 0x1720cd30861a05p-53; 1; 1]%float, 2, 0, 0x277de46b410d9p-51%float, [-0x1ec83b38745225p-50; -0x114d2463df8f0bp-49; -0x92eb8e02d2b41p-48; 0x42fb16106c43p-43]%float, [-0x1191b0a98454d5p-49]%float);
(1, [0; 0; 0xad3bf7c68cb73p-54; 0x1720cd30861a05p-53; 1; 1]%float, 2, 0, 0x78255d61643f7p-52%float, [-0x771bad8f77405p-48; 0x45c1236f24721p-47; 0x12c8703dd65f1p-46; 0x1d8e97eea3a7p-46]%float, [0x1a26abf16305d9p-50]%float);
(1, [0; 0; 0xad3bf7c68cb73p-54; 0x1720cd30861a05p-53; 1; 1]%float, 3, 0, 0x1720cd30861a05p-53%float, [0x1ca06b51b9f7fp-48; 0xbc42d57f333b5p-49; -0xa1640623e2ea9p-49; 0x96a959717365p-44]%float, [-0xa1640623e2ea9p-49]%float);
(1, [0; 0; 0xad3bf7c68cb73p-54; 0x1720cd30861a05p-53; 1; 1]%float, 3, 0, 0x1fffffffffffffp-53%float, [0x46277c684e06bp-47; 0x28e1cb3db2c95p-48; 0x9e83a1090c97dp-49; -0x88f1655505dcbp-49]%float, [-0x88f1655505dc9p-49]%float);
(1, [0; 0; 0xad3bf7c68cb73p-54; 0x1720cd30861a05p-53; 1; 1]%float, 3, 0, 2%float, [-0xf54433b83729bp-50; 0x20f64e2d47107p-49; 0x434cbf4b321b9p-49; -0x122b4a3c7d6a09p-49]%float, [-0x122b4a3c7d6a09p-49]%float);
(1, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x156e3f69813adfp-53; 0x14024177e9619p-51; 0x8eeb9ce144f63p-52; 0xe5104a0474be3p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 1, 0, -0x9333333333333p-50%float, [0xa39faff025f83p-49; 0x73fb8ed8dd225p-48; 0x836bbf6c46c51p-49; -0x116bce034c1a5p-49; -0x2bea640621847p-47; 0x337712137eedfp-48]%float, [0xa39faff025f83p-49]%float);
(1, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x156e3f69813adfp-53; 0x14024177e9619p-51; 0x8eeb9ce144f63p-52; 0xe5104a0474be3p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 1, 0, -0x14cccccccccccdp-52%float, [0x6c49d85c14fb9p-48; -0x4c209c7f0b26fp-47; 0xb894fc55fb259p-49; 0x8f63e15d19f93p-48; 0x1767fdbd97c9p-46; 0xb3e0cf1f6fab1p-49]%float, [0x6c49d85c14fb9p-48]%float);
(1, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x156e3f69813adfp-53; 0x14024177e9619p-51; 0x8eeb9ce144f63p-52; 0xe5104a0474be3p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 1, 0, -0xab71fb4c09d7p-48%float, [0x4bca30d1e519p-48; -0x1c7e5f61416cddp-50; 0x931d2dc5a45cdp-48; -0x1345b48b61b23fp-50; 0x21f1e79ed3ccdp-48; -0x19ada02dde0efp-48]%float, [-0x71f97d8505b37p-48]%float);
(1, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x156e3f69813adfp-53; 0x14024177e9619p-51; 0x8eeb9ce144f63p-52; 0xe5104a0474be3p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 4, 0, 0xba9610f1e3c05p-52%float, [0x6d28c3148adffp-49; -0x9e19e66d50c4bp-49; -0xebb5f5331b573p-49; -0xd2bebf88548afp-49; -0xeea4c4698d33p-48; -0x55ded103ab6d1p-48]%float, [-0x1dc28d2a6fc73dp-51]%float);
(1, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x156e3f69813adfp-53; 0x14024177e9619p-51; 0x8eeb9ce144f63p-52; 0xe5104a0474be3p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 5, 0, 0x1ca209408e97c7p-53%float, [0x278fe07477b5p-42; -0x1566ef8cdc7fdp-46; -0x2364c4da1dbe7p-49; -0x9f80147990cf5p-49; 0x1d3229d120cdp-44; 0x27bb84dfa9d0dp-48]%float, [0x1d3229d120cd01p-52]%float);
(1, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x156e3f69813adfp-53; 0x14024177e9619p-51; 0x8eeb9ce144f63p-52; 0xe5104a0474be3p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 5, 0, 0x86ad2cfe43bb5p-50%float, [-0x4de2912c9e197p-48; -0x3144e849b376bp-49; 0x8617aee06f0dp-48; -0x9e74c101f493fp-48; -0x12947c6c138437p-49; -0x3a6a43832e5f3p-49]%float, [-0xd2ac852c46231p-50]%float);
(1, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x156e3f69813adfp-53; 0x14024177e9619p-51; 0x8eeb9ce144f63p-52; 0xe5104a0474be3p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 5, 0, 0x6cccccccccccdp-49%float, [-0x52ec4c0bec6ddp-48; -0x801296b7353adp-48; -0xcbac6dc3f403fp-49; -0x55e96fd3ca80dp-48; -0x169c98f9c16efp-46; 0xd4572258f261p-49]%float, [0xd4572258f261p-49]%float);
(1, [0; 0; 0x41c34515804f9p-451; 0x127d4b8969c0b3p-453; 0x1e7a9ce363ccdp-449; 0x1p-400; 0x1p-400]%float, 1, 0, -1%float, [-0x1d87f36738cf7p-49; 0xb5ee439ab9c1p-48; -0x4ccc5b2f01079p-49; 0x76330e1886675p-49; 0xa6bc663d0ca1p-45]%float, [-0x1d87f36738cf7p-49]%float);
(1, [0; 0; 0x41c34515804f9p-451; 0x127d4b8969c0b3p-453; 0x1e7a9ce363ccdp-449; 0x1p-400; 0x1p-400]%float, 2, 0, 0x93ea5c4b4e059p-452%float, [0x928410007c837p-49; -0xa9a42bf7ceefp-47; 0x75c6141b4affp-49; 0xcf8e2afd3acfp-47; -0x8f9ad98cbe15bp-48]%float, [0xeb8c283695fafp-54]%float);
(1, [0; 0; 0x41c34515804f9p-451; 0x127d4b8969c0b3p-453; 0x1e7a9ce363ccdp-449; 0x1p-400; 0x1p-400]%float, 3, 0, 0x9be3cedea0b25p-452%float, [0x434c71e1e0303p-47; 0x6881c7c03660fp-49; -0x6768ef95a46bp-48; -0x13387ec967695fp-49; 0x936a150cdba6dp-48]%float, [-0x12b5b12bd97ee3p-52]%float);
(1, [0; 0; 0x41c34515804f9p-451; 0x127d4b8969c0b3p-453; 0x1e7a9ce363ccdp-449; 0x1p-400; 0x1p-400]%float, 3, 0, 0x17573f0c05d89dp-453%float, [-0x10d562c91896fp-46; 0x26ae82f75310bp-46; -0x1471980dd5a27p-47; -0x99e7017d06afdp-48; 0x1da6533c3ebdfp-47]%float, [-0xad3bfca30f0b9p-49]%float);
(1, [0; 0; 0x41c34515804f9p-451; 0x127d4b8969c0b3p-453; 0x1e7a9ce363ccdp-449; 0x1p-400; 0x1p-400]%float, 4, 0, 0x1e7a9ce363ccdp-449%float, [-0xf86b5c6041e3fp-50; 0x6cfee8cf03753p-48; 0x373914010408bp-48; -0x4d7c061fc2403p-47; -0xf8b63e599b1dp-48]%float, [-0x4d7c061fc2403p-47]%float);
(1, [0; 0; 0x41c34515804f9p-451; 0x127d4b8969c0b3p-453; 0x1e7a9ce363ccdp-449; 0x1p-400; 0x1p-400]%float, 4, 0, 0x10000000000001p-452%float, [-0x177666ff571a9p-49; 0x3e53a2efc65ffp-47; 0x915a3c0bce69p-46; -0x13c97051940521p-49; -0x1308c94622af71p-49]%float, [-0x1308c94622af71p-49]%float);
(1, [0; 0; 0x41c34515804f9p-451; 0x127d4b8969c0b3p-453; 0x1e7a9ce363ccdp-449; 0x1p-400; 0x1p-400]%float, 4, 0, 1%float, [0x22d256a73c539p-46; -0x10f0256ee777edp-49; 0xa33098e73c525p-49; -0x6271f0b35e883p-48; 0x5b9666fbbe3dp-46]%float, [0x5b9666fbbe3dp-46]%float);
(1, [-0x109b9793e6667p-50; -0x30dc351bdd305p-52; 0xc89da11b6c209p-52; 0x6905aeaf463b3p-51; 0xe2dcaa3e07db9p-52; 0x184c81998e07p-44; 0x18fb526269355dp-52]%float, 1, 0, -0x509b9793e6667p-50%float, [0x45188caa876afp-48; -0x734e9e21db55fp-48; -0x633d2dd065875p-49; 0xf81f6789bd05p-45; -0x4eab06c32113p-44]%float, [0x45188caa876afp-48]%float);
(1, [-0x109b9793e6667p-50; -0x30dc351bdd305p-52; 0xc89da11b6c209p-52; 0x6905aeaf463b3p-51; 0xe2dcaa3e07db9p-52; 0x184c81998e07p-44; 0x18fb526269355dp-52]%float, 1, 0, -0x186e1a8dee9829p-55%float, [-0x863c8fdf569d9p-48; 0x7005ce55611b9p-48; 0x168f0403d2745p-47; 0x93180c787afb3p-48; 0x3da618bc374e9p-48]%float, [-0x863c8fdf569d9p-48]%float);
(1, [-0x109b9793e6667p-50; -0x30dc351bdd305p-52; 0xc89da11b6c209p-52; 0x6905aeaf463b3p-51; 0xe2dcaa3e07db9p-52; 0x184c81998e07p-44; 0x18fb526269355dp-52]%float, 1, 0, 0x19130d3895e77bp-53%float, [0x4ba2ef74bb97p-45; -0x97aec10e9599p-48; -0x1245d50661e589p-49; 0x1076db56fac03p-46; -0x85eb0dc364aadp-49]%float, [-0x12f3ddcbac1cbbp-53]%float);
(1, [-0x109b9793e6667p-50; -0x30dc351bdd305p-52; 0xc89da11b6c209p-52; 0x6905aeaf463b3p-51; 0xe2dcaa3e07db9p-52; 0x184c81998e07p-44; 0x18fb526269355dp-52]%float, 4, 0, 0xe2dcaa3e07db9p-52%float, [0x2fcba8137f8d5p-47; -0x49f03b1ca1c6bp-48; 0x10d59b054372fp-49; -0xe5ca5066fae7p-49; 0x48c062028eeadp-47]%float, [-0xe5ca5066fae7p-49]%float);
(1, [-0x109b9793e6667p-50; -0x30dc351bdd305p-52; 0xc89da11b6c209p-52; 0x6905aeaf463b3p-51; 0xe2dcaa3e07db9p-52; 0x184c81998e07p-44; 0x18fb526269355dp-52]%float, 4, 0, 0x1c5b9547c0fb73p-53%float, [0x1ae164e6cd5f5p-46; -0x82123d906d1f1p-49; -0x1578458a6f9e03p-50; -0x1cb2ee411a29p-47; -0x133f60ec83afp-42]%float, [-0x72cbb90468a47p-53]%float);
(1, [-0x109b9793e6667p-50; -0x30dc351bdd305p-52; 0xc89da11b6c209p-52; 0x6905aeaf463b3p-51; 0xe2dcaa3e07db9p-52; 0x184c81998e07p-44; 0x18fb526269355dp-52]%float, 4, 0, 0x14be4848c8bac5p-52%float, [0x1b7cf9bd1cae5p-48; 0x65b689df07b0dp-48; -0x10297fe1a4ea57p-49; -0xb83f2ae3d1893p-50; 0x27d1e12573e05p-46]%float, [0x15c89e63ac7f1fp-50]%float);
(1, [-0x109b9793e6667p-50; -0x30dc351bdd305p-52; 0xc89da11b6c209p-52; 0x6905aeaf463b3p-51; 0xe2dcaa3e07db9p-52; 0x184c81998e07p-44; 0x18fb526269355dp-52]%float, 4, 0, 0xa3ed4989a4d57p-50%float, [0x7f6cefdaac6f7p-48; 0xbf15cb06e456bp-49; 0x83a31c03d1ec7p-48; 0x1d044a7fc5d25p-47; 0x18c8eb987b171p-46]%float, [0x18c8eb987b171p-46]%float);
(2, [0; 0; 0; 0x1p-60; 1; 1; 1]%float, 2, 0, -1%float, [-0x1db8034042c74bp-50; -0x20942c0830289p-47; -0x2aed9525d4f9dp-47; 0x6d44c8c6d001fp-49]%float, [-0x1db8034042c74bp-50]%float);
(2, [0; 0; 0; 0x1p-60; 1; 1; 1]%float, 2, 0, 0x1fffffffffffffp-113%float, [-0x6d2cb3fce47p-41; -0x68ca4c6b0a4b3p-48; -0x8853d52708cd1p-49; -0x6e12fe6a5d40dp-48]%float, [-0x68ca4c6b0a4b3p-48]%float);
(2, [0; 0; 0; 0x1p-60; 1; 1; 1]%float, 3, 0, 0x10000000000001p-112%float, [-0x36c521235706bp-48; -0x50729bbb62aa1p-48; 0x488799a4a59p-44; -0xd37a520868845p-49]%float, [-0x50729bbb62aa1p-48]%float);
(2, [0; 0; 0; 0x1p-60; 1; 1; 1]%float, 3, 0, 0x350bdcd58989p-47%float, [0x4794ed3a108b3p-47; -0xa9f431ffaabbfp-49; 0xefa8deff9c53p-45; -0xb50d4862bfde3p-50]%float, [0x153f5fe87d0941p-52]%float);
(2, [0; 0; 0; 0x1p-60; 1; 1; 1]%float, 3, 0, 0x1a06f9bd6d5a59p-53%float, [-0xe359b2daaad1dp-49; -0x25a488e67d92dp-49; -0x4b4c64e3ce2c5p-47; 0xf39ecb3aa3f3p-47]%float, [-0x1a3c0c2e5ca51fp-52]%float);
(2, [0; 0; 0; 0x1p-60; 1; 1; 1]%float, 3, 0, 1%float, [-0x8924c86e5f601p-50; -0x8edb5aa4b3a07p-48; -0x90ac024f9b58fp-49; -0x4ecf224394e39p-48]%float, [-0x4ecf224394e39p-48]%float);
(2, [0; 0; 0; 0x1p-60; 1; 1; 1]%float, 3, 0, 2%float, [0x8bbbfff07c5ebp-48; 0x20dce0d8f564dp-47; -0x233378066207p-46; 0x49ea9842f3995p-47]%float, [0x49ea9842f3995p-47]%float);
(2, [0; 0; 0; 1; 1; 1]%float, 2, 0, -1%float, [0x443e394dd3131p-48; 0x83d476fa56e3p-44; -0x85f29bf989201p-48]%float, [0x443e394dd3131p-48]%float);
(2, [0; 0; 0; 1; 1; 1]%float, 2, 0, 0x1p-1074%float, [-0xb0002ef55f23dp-49; 0x4d9970df07b1bp-49; -0x1f20dbff593p-40]%float, [-0xb0002ef55f23dp-49]%float);
(2, [0; 0; 0; 1; 1; 1]%float, 2, 0, 0xa2a7ae05abb6fp-52%float, [0x98b703bb3ccbp-44; 0x1592abe64ca55p-47; -0x9c4940db7b8e7p-48]%float, [-0x16cbe46022927p-48]%float);
(2, [0; 0; 0; 1; 1; 1]%float, 2, 0, 0x66fc2203ac765p-51%float, [0x43b4587444be5p-48; 0x3d50bac5537ebp-47; 0x3006f7471841bp-48]%float, [0x907ab5bbed255p-49]%float);
(2, [0; 0; 0; 1; 1; 1]%float, 2, 0, 0x1fffffffffffffp-53%float, [-0x1f10a7da45545p-48; -0x2d5b0bc169257p-47; 0x2c54ca3083f8dp-49]%float, [0x162a651841fc61p-52]%float);
(2, [0; 0; 0; 1; 1; 1]%float, 2, 0, 1%float, [0x1ec63da5b9d3dp-46; -0xffb51010cd1ffp-49; 0x193fec2993c59p-46]%float, [0x193fec2993c59p-46]%float);
(2, [0; 0; 0; 1; 1; 1]%float, 2, 0, 2%float, [-0x120c168c8ebb27p-50; 0x86d8099f72f81p-48; 0xcd5ebdfd4739p-47]%float, [0xcd5ebdfd4739p-47]%float);
(2, [0; 0; 0; 0x80fd92bc983c5p-54; 0xaa95dd25b0f23p-54; 0x914c2e9e3a62dp-52; 0x17a3d974f69a63p-53; 0x17a3d974f69a63p-53; 1; 1; 1]%float, 2, 0, -1%float, [0x615732007a1efp-48; -0x73e16eefa91efp-48; 0x47e31db64bb13p-49; -0x14fe1dfcb7be9p-48; -0x4ed19fcb765cbp-48; 0x152678b6f153p-44; -0xa883e2b7dcfbp-48; -0x2f334d788d627p-47]%float, [0x615732007a1efp-48]%float);
(2, [0; 0; 0; 0x80fd92bc983c5p-54; 0xaa95dd25b0f23p-54; 0x914c2e9e3a62dp-52; 0x17a3d974f69a63p-53; 0x17a3d974f69a63p-53; 1; 1; 1]%float, 2, 0, -0x1p-1074%float, [-0x5fd911afc1cbfp-49; 0x81d115c36abb9p-48; 0x2a73e7a5f35dp-46; 0x6c3762c4ac13p-45; -0x8b0ec559d02fp-44; 0x1d4cb82366679p-48; 0x43fd53b97efcfp-47; 0x871eaf5d6547bp-48]%float, [-0x5fd911afc1cbfp-49]%float);
(2, [0; 0; 0; 0x80fd92bc983c5p-54; 0xaa95dd25b0f23p-54; 0x914c2e9e3a62dp-52; 0x17a3d974f69a63p-53; 0x17a3d974f69a63p-53; 1; 1; 1]%float, 2, 0, 0x380ee4b306c3p-49%float, [-0x9527b019cc5a1p-49; 0xeda04269af1p-48; -0x9730ebd8843afp-48; -0x8676148f75ed1p-48; 0xa288c38bcf971p-49; -0x686a86919d72dp-48; 0xa029e5eb14d7fp-49; 0x5b00148fe8bf7p-48]%float, [-0x15d0ed60e5ca25p-50]%float);
(2, [0; 0; 0; 0x80fd92bc983c5p-54; 0xaa95dd25b0f23p-54; 0x914c2e9e3a62dp-52; 0x17a3d974f69a63p-53; 0x17a3d974f69a63p-53; 1; 1; 1]%float, 4, 0, 0x1552bba4b61e47p-55%float, [0x1bffb88880ad1p-47; 0xb7f344a2acca9p-49; 0x1d1f36ad32153p-46; -0x1d35db71758e7fp-50; -0x35fd207a02a63p-47; -0x4bbc43f09dc89p-49; -0xb4f52dcf90ffp-48; -0x41a87021c41d9p-48]%float, [0x17c19e62a0589bp-50]%float);
(2, [0; 0; 0; 0x80fd92bc983c5p-54; 0xaa95dd25b0f23p-54; 0x914c2e9e3a62dp-52; 0x17a3d974f69a63p-53; 0x17a3d974f69a63p-53; 1; 1; 1]%float, 4, 0, 0x7fc63a11316d1p-53%float, [0x24bff78564301p-49; 0x255a64d004a8bp-46; -0xaaee7dba8ea77p-50; 0xc28e99a0058dp-48; -0x25a798796d81p-44; -0x926e473e965p-43; 0x3b476c1987421p-47; -0x7a9ac1882344bp-49]%float, [-0xa57b2bb723d7dp-51]%float);
(2, [0; 0; 0; 0x80fd92bc983c5p-54; 0xaa95dd25b0f23p-54; 0x914c2e9e3a62dp-52; 0x17a3d974f69a63p-53; 0x17a3d974f69a63p-53; 1; 1; 1]%float, 5, 0, 0x914c2e9e3a62dp-52%float, [-0x53034fc6a367p-48; 0xc57962c71bd7p-48; 0x425a3d720dddbp-47; -0x10ee72d2b5c839p-49; 0x19f31b3f217b5p-46; -0x3eaa734aa6d7p-44; 0xbb464b77be89p-46; 0xbd569618f94c7p-49]%float, [0x101bfd66f912a5p-51]%float);
(2, [0; 0; 0; 0x80fd92bc983c5p-54; 0xaa95dd25b0f23p-54; 0x914c2e9e3a62dp-52; 0x17a3d974f69a63p-53; 0x17a3d974f69a63p-53; 1; 1; 1]%float, 7, 0, 2%float, [0x5c97fe1a0d11p-48; 0x868f136bb7cbbp-48; 0x2b4ff995523bp-48; -0x5c9aa0085adf3p-48; 0x3d90250a6ff17p-49; 0x6f68c5a209a3p-44; -0x3812e90c0aee9p-47; 0x5fa60a49d4bp-46]%float, [0x5fa60a49d4bp-46]%float);
(2, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x15c5820c099c61p-53; -0x13bdfdd34d735fp-53; -0x5b0f2dd18ee3bp-52; -0x39d7ba97c4f61p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 2, 0, -0x9333333333333p-50%float, [-0x7ad44a6cb8e97p-49; -0x155decc8811253p-50; -0x1b2cf06318843p-49; -0x2adccab98c1f5p-47; -0x11cd136763263bp-50; 0x493da1523cfe7p-47; -0xf8577ae9f8449p-49]%float, [-0x7ad44a6cb8e97p-49]%float);
(2, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x15c5820c099c61p-53; -0x13bdfdd34d735fp-53; -0x5b0f2dd18ee3bp-52; -0x39d7ba97c4f61p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 3, 0, -0x15c5820c099c61p-53%float, [0x390e38234ac4fp-47; -0xb738ab3687579p-49; -0x5c1b7679cf24dp-49; -0x69c889fb68da9p-49; -0x57df2e82ae235p-49; -0x18be49ca3a81p-49; 0x7635b5dbadf2dp-48]%float, [-0x192443c892a02bp-51]%float);
(2, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x15c5820c099c61p-53; -0x13bdfdd34d735fp-53; -0x5b0f2dd18ee3bp-52; -0x39d7ba97c4f61p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 4, 0, -0x9defee9a6b9afp-52%float, [0x86f52444bd4b3p-48; -0x251f4bc0bdeabp-49; 0x1656d828516ddp-47; 0x44be251975ef7p-47; -0x379b8361a3fedp-48; -0x100490248fb8cbp-49; -0xa7c7fc9a7d211p-49]%float, [0xfb3a5a23a719bp-50]%float);
(2, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x15c5820c099c61p-53; -0x13bdfdd34d735fp-53; -0x5b0f2dd18ee3bp-52; -0x39d7ba97c4f61p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 6, 0, -0x35db3fc090365p-52%float, [0x6eca25e6f397bp-48; -0x192c59e47063adp-50; -0x1cc7cab20c8cdp-46; -0xe95b2cad58a2dp-49; -0x4a095effa8967p-48; 0x206244f2a1edbp-49; -0x4e136feffaac5p-49]%float, [-0x898c03fbde071p-49]%float);
(2, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x15c5820c099c61p-53; -0x13bdfdd34d735fp-53; -0x5b0f2dd18ee3bp-52; -0x39d7ba97c4f61p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 6, 0, 0x1192d7d8440933p-52%float, [-0x8c52d789b6a7bp-49; 0x8cd8224a12f67p-49; 0x1e6e63c41ab05p-48; 0x19dfd993996ddp-48; 0x948dcc1be70ebp-49; -0x72e37304985f9p-49; -0x10179038fad81p-47]%float, [-0xa16e92c8804d5p-51]%float);
(2, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x15c5820c099c61p-53; -0x13bdfdd34d735fp-53; -0x5b0f2dd18ee3bp-52; -0x39d7ba97c4f61p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 6, 0, 0x13333333333333p-51%float, [0x45b0fbd8a4941p-47; 0xa2430ffd8fdcbp-49; 0x994d5904a7933p-48; -0x10abe8e6ae3c2fp-50; 0x273211d17acfdp-48; 0x1b4e26217410dp-47; -0xa9af232ea0555p-50]%float, [-0x1535e465d40aa5p-51]%float);
(2, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x15c5820c099c61p-53; -0x13bdfdd34d735fp-53; -0x5b0f2dd18ee3bp-52; -0x39d7ba97c4f61p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 6, 0, 0x6cccccccccccdp-49%float, [-0x1a049fb76bb843p-50; 0x493be55206d4bp-47; -0x5d70101cbdc0bp-49; -0x77a244c7dfa5p-48; 0x3ef86cd27865fp-47; -0xc8ac0476cf45fp-49; 0x49b505cb948d5p-47]%float, [0x49b505cb948d5p-47]%float);
(2, [0; 0; 0; 0x3a773241833a9p-453; 0x7f1a354f2921dp-452; 0x1p-400; 0x1p-400; 0x1p-400]%float, 2, 0, -1%float, [0x95c1bc791f05bp-48; -0xfd4481d3f0069p-49; -0xd510b1734419bp-49; -0x10eb2421696a5p-45; 0x7916d3fb53e8bp-48]%float, [0x95c1bc791f05bp-48]%float);
(2, [0; 0; 0; 0x3a773241833a9p-453; 0x7f1a354f2921dp-452; 0x1p-400; 0x1p-400; 0x1p-400]%float, 3, 0, 0xc08d602113efp-450%float, [0xa76624d423f63p-49; -0x1457d397aa20bp-48; 0x1b51bd99a1a31p-49; -0x150ef49dbfd195p-50; 0x1aaeb027f24a9p-46]%float, [-0x13d7ffd6e07c05p-54]%float);
(2, [0; 0; 0; 0x3a773241833a9p-453; 0x7f1a354f2921dp-452; 0x1p-400; 0x1p-400; 0x1p-400]%float, 3, 0, 0xd782a732f4fd7p-453%float, [-0x113a4cc74f9f57p-50; 0x583223180e569p-49; -0xdfa1342336dbp-45; -0x1d62485bf5191p-47; 0x44303b59f8123p-47]%float, [-0x1718b3204c00c7p-50]%float);
(2, [0; 0; 0; 0x3a773241833a9p-453; 0x7f1a354f2921dp-452; 0x1p-400; 0x1p-400; 0x1p-400]%float, 4, 0, 0x7f1a354f2921dp-452%float, [0x16b5daec0b1ffp-46; -0x35f95255f5f6fp-48; -0x1cb0cb67cbc843p-50; -0xb2ac3137f8c83p-50; -0x8379879a4adbp-44]%float, [-0xa9057b5d63769p-49]%float);
(2, [0; 0; 0; 0x3a773241833a9p-453; 0x7f1a354f2921dp-452; 0x1p-400; 0x1p-400; 0x1p-400]%float, 4, 0, 0x1fc68d53ca4875p-454%float, [0x212c8874cd40bp-47; 0x91f18270d92f7p-49; -0x12203b5e51556bp-49; 0x8cd4ac96e95c1p-48; 0x5eb41dad6ce21p-49]%float, [-0xad25f5c75472dp-51]%float);
(2, [0; 0; 0; 0x3a773241833a9p-453; 0x7f1a354f2921dp-452; 0x1p-400; 0x1p-400; 0x1p-400]%float, 4, 0, 0x1fffffffffffffp-453%float, [0xe7deb9cb85fdp-45; -0x67356535f791p-44; -0x117a400ed9e28dp-49; -0x90610f86c86bp-47; -0x91f9ef656063fp-49]%float, [-0x123f3decac0c7dp-50]%float);
(2, [0; 0; 0; 0x3a773241833a9p-453; 0x7f1a354f2921dp-452; 0x1p-400; 0x1p-400; 0x1p-400]%float, 4, 0, 1%float, [0x1892bd31d0a13p-48; -0xf57e9804f4e7dp-49; 0x17b633635d131p-47; 0x86c74510d4807p-49; 0x925d07efc86fp-44]%float, [0x925d07efc86fp-44]%float);
(2, [-0x17e3abbc6695fbp-53; -0x8a297c9f5a429p-53; -0x5f47af94f207p-52; 0xb7407d2d12983p-51; 0x7dcbcaecd85e5p-50; 0x7e6f77a82aa2bp-50]%float, 2, 0, -0xdf8eaef19a57fp-51%float, [0x4f9381a115337p-47; -0x44ed1c82ac8b1p-49; -0x10c5b178d00dfp-49]%float, [0x1062fb2842700bp-49]%float);
(2, [-0x17e3abbc6695fbp-53; -0x8a297c9f5a429p-53; -0x5f47af94f207p-52; 0xb7407d2d12983p-51; 0x7dcbcaecd85e5p-50; 0x7e6f77a82aa2bp-50]%float, 2, 0, -0x17d1ebe53c81c1p-58%float, [0x3b6b5b5e5636fp-47; 0xe483031816c5p-48; 0x26e3c907e6c4fp-48]%float, [0x19ebe928b2e1fdp-50]%float);
(2, [-0x17e3abbc6695fbp-53; -0x8a297c9f5a429p-53; -0x5f47af94f207p-52; 0xb7407d2d12983p-51; 0x7dcbcaecd85e5p-50; 0x7e6f77a82aa2bp-50]%float, 2, 0, -0x5f47af94f207p-52%float, [0x70a408b1ab1dp-46; 0x62c7fb54b263p-47; 0x26cb70b0f5049p-46]%float, [0x33bcb8bcb62e5p-49]%float);
(2, [-0x17e3abbc6695fbp-53; -0x8a297c9f5a429p-53; -0x5f47af94f207p-52; 0xb7407d2d12983p-51; 0x7dcbcaecd85e5p-50; 0x7e6f77a82aa2bp-50]%float, 2, 0, 0x184c489b695485p-55%float, [-0x69ca82978745dp-48; -0x48f668f604c6bp-49; -0x1e4e768c4eb29p-49]%float, [-0x9ea558bda305p-45]%float);
(2, [-0x17e3abbc6695fbp-53; -0x8a297c9f5a429p-53; -0x5f47af94f207p-52; 0xb7407d2d12983p-51; 0x7dcbcaecd85e5p-50; 0x7e6f77a82aa2bp-50]%float, 2, 0, 0x105c817b2c1aa5p-52%float, [0x9e7b81b7a7509p-48; -0x3b7c7f4da185dp-47; 0x8bf6883cda303p-48]%float, [-0x959f91e98f2fp-50]%float);
(2, [-0x17e3abbc6695fbp-53; -0x8a297c9f5a429p-53; -0x5f47af94f207p-52; 0xb7407d2d12983p-51; 0x7dcbcaecd85e5p-50; 0x7e6f77a82aa2bp-50]%float, 2, 0, 0x16e80fa5a25307p-52%float, [0x426a190b807b7p-47; -0x10e813010972fdp-49; -0x7c48088b6273p-45]%float, [-0xa3891c72cf1f7p-49]%float);
(2, [-0x17e3abbc6695fbp-53; -0x8a297c9f5a429p-53; -0x5f47af94f207p-52; 0xb7407d2d12983p-51; 0x7dcbcaecd85e5p-50; 0x7e6f77a82aa2bp-50]%float, 2, 0, 0xbe6f77a82aa2bp-50%float, [-0x13a56c2ebc3a7fp-49; -0x7e17c22d40915p-48; -0x5f96f1ce5a539p-49]%float, [-0x89a0e1372049dp-49]%float);
(3, [0; 0; 0; 0; 0x1p-28; 1; 1; 1; 1]%float, 3, 0, -1%float, [-0x260139f28809bp-46; -0x17432f15359cfp-48; 0x9aab8ed3ad4a7p-48; -0x3479f5e923cbbp-48; 0x664fd4d9f9761p-48]%float, [-0x260139f28809bp-46]%float);
(3, [0; 0; 0; 0; 0x1p-28; 1; 1; 1; 1]%float, 4, 0, 0xda73d6a2dc667p-53%float, [-0x120263c4b57953p-49; 0x1fe5cadebf9b9p-46; -0xa56c4b1ad4901p-49; -0xbdcef94d7173p-49; 0x259c51126e0a3p-49]%float, [-0x164d93ba97bf25p-53]%float);
(3, [0; 0; 0; 0; 0x1p-28; 1; 1; 1; 1]%float, 4, 0, 0xd50e00870f273p-52%float, [-0x1210f4c40080c5p-49; 0x762883e5f18bp-47; -0x9e01feef1e39p-44; 0x3247415e752bbp-47; -0x19fc73225cf33p-47]%float, [-0x17c1e6c29f601p-50]%float);
(3, [0; 0; 0; 0; 0x1p-28; 1; 1; 1; 1]%float, 4, 0, 0x1fffffffffffffp-53%float, [-0x399afc0491cf7p-47; -0x50ddbcfe11ebp-49; -0xebabdd54ca0e9p-49; -0x3d5b521f10e55p-47; -0xfabab41ab0c01p-49]%float, [-0x7d5d5a0d58601p-48]%float);
(3, [0; 0; 0; 0; 0x1p-28; 1; 1; 1; 1]%float, 4, 0, 1%float, [0x2521b1889bd27p-48; 0x2870be172a4efp-48; -0x687c5a3e2f5a3p-49; 0x179df2a52c0fbp-47; -0x87e37c4f5497p-46]%float, [-0x87e37c4f5497p-46]%float);
(3, [0; 0; 0; 0; 0x1p-28; 1; 1; 1; 1]%float, 4, 0, 0x10000000000001p-52%float, [0x7d6d4ac4893fp-48; 0xb3ce7a795be6bp-49; 0x3822a1e685163p-48; 0x1c162d21be17p-47; 0x6aa92230b65cdp-48]%float, [0x6aa92230b65cdp-48]%float);
(3, [0; 0; 0; 0; 0x1p-28; 1; 1; 1; 1]%float, 4, 0, 2%float, [0x28aea2b649779p-48; -0x5cb308a90fa93p-48; -0x4e8723afd93f1p-49; -0x40d57fca5fdd3p-48; -0xb0fd69d20233p-47]%float, [-0xb0fd69d20233p-47]%float);
(3, [0; 0; 0; 0; 0x1e6d528ce48d6fp-54; 0x1e6d528ce48d7p-50; 0x1e6d528ce48d71p-54; 0xf36a9467246b9p-53; 1; 1; 1; 1]%float, 3, 0, -1%float, [-0xec8afdb025c4dp-49; -0x773d03802e499p-49; -0x80736e7f14617p-49; -0x10070536300c35p-49; -0x1000703ba2d77dp-49; -0x48d74ffc9f233p-48; 0x46192534e9d7p-47; -0x7172c610c90dp-49]%float, [-0xec8afdb025c4dp-49]%float);
(3, [0; 0; 0; 0; 0x1e6d528ce48d6fp-54; 0x1e6d528ce48d7p-50; 0x1e6d528ce48d71p-54; 0xf36a9467246b9p-53; 1; 1; 1; 1]%float, 3, 0, 0x1e19152f3266bp-53%float, [-0xad5fc48e589c5p-49; 0x207e86d2c0957p-47; 0xfecaa8b78675p-46; 0x195115461463dp-47; -0x258d00b9fafe7p-46; 0x42352ab8484dp-46; -0x17d6c39be068c3p-50; -0x61cf5b905750bp-48]%float, [-0x129623c1fdbf15p-51]%float);
(3, [0; 0; 0; 0; 0x1e6d528ce48d6fp-54; 0x1e6d528ce48d7p-50; 0x1e6d528ce48d71p-54; 0xf36a9467246b9p-53; 1; 1; 1; 1]%float, 3, 0, 0x4c7170840599p-48%float, [0x5cdbcbbb0c40dp-49; 0xa08db4e3c31fp-46; 0x9b01d66500387p-49; 0x81b12199bed97p-49; -0x3f9d5f934d71p-47; -0x90b4eaa28a107p-48; 0xae38f454e67d7p-49; 0x6762dcc0fb33fp-48]%float, [0xfc1ef9d11f0a7p-50]%float);
(3, [0; 0; 0; 0; 0x1e6d528ce48d6fp-54; 0x1e6d528ce48d7p-50; 0x1e6d528ce48d71p-54; 0xf36a9467246b9p-53; 1; 1; 1; 1]%float, 7, 0, 0xf36a9467246b9p-53%float, [-0x49e4959238259p-47; -0x185448140750b7p-50; -0xfaa8f7e4c43d9p-49; 0x2b77e353c13bp-44; 0xe2b890cadc9fp-48; -0xc8a7b032f83a7p-49; 0x123ba0da761efp-45; 0x4c79e7e1bc39dp-47]%float, [0xe2b890cadc9e5p-52]%float);
(3, [0; 0; 0; 0; 0x1e6d528ce48d6fp-54; 0x1e6d528ce48d7p-50; 0x1e6d528ce48d71p-54; 0xf36a9467246b9p-53; 1; 1; 1; 1]%float, 7, 0, 0x1fffffffffffffp-53%float, [-0x10a80a745ef989p-50; -0xba5369a36556fp-49; 0x67b7a704f9149p-48; 0x404ca1b0ccd6bp-48; -0x8e804bac041a3p-49; 0x203257152f135p-46; 0x2c1df43566fedp-49; -0x6fc2cf90500fp-46]%float, [-0x1bf0b3e41403b7p-52]%float);
(3, [0; 0; 0; 0; 0x1e6d528ce48d6fp-54; 0x1e6d528ce48d7p-50; 0x1e6d528ce48d71p-54; 0xf36a9467246b9p-53; 1; 1; 1; 1]%float, 7, 0, 1%float, [-0xe48f0d41a715p-48; 0x65ec5614f787bp-49; -0xf1e5ef7d1569p-45; 0x817b4e3abdce1p-49; -0x48e208423a8f7p-48; 0x41ad6aec50a17p-47; -0x5b64d63f41ab3p-48; -0x1aaf4a36c53e1p-47]%float, [-0x1aaf4a36c53e1p-47]%float);
(3, [0; 0; 0; 0; 0x1e6d528ce48d6fp-54; 0x1e6d528ce48d7p-50; 0x1e6d528ce48d71p-54; 0xf36a9467246b9p-53; 1; 1; 1; 1]%float, 7, 0, 2%float, [0x91d9f9af64661p-49; 0xef71bde82569p-47; 0x4f448e34f3c7bp-48; 0x1f584a1802f65p-46; -0x167d64111cdcdp-48; -0xed9938a88940bp-49; -0x695713c08cefbp-48; 0x77d47a09e825p-44]%float, [0x77d47a09e825p-44]%float);
(3, [0; 0; 0; 0; 0x199d19e9c07687p-53; 0x199d19e9c07687p-53; 1; 1; 1; 1]%float, 3, 0, -1%float, [0x4b4755beeac05p-47; -0x4af850aa23fe3p-49; 0x240f3dda2ee35p-48; 0x24d9b297a2463p-48; 0x19dc72eb0b523p-48; -0x8cf3184284afp-47]%float, [0x4b4755beeac05p-47]%float);
(3, [0; 0; 0; 0; 0x199d19e9c07687p-53; 0x199d19e9c07687p-53; 1; 1; 1; 1]%float, 3, 0, -0x1p-1074%float, [0x380155c777565p-47; -0xcfac142e7c73bp-50; -0x895ad1892ed99p-48; -0x538a4f1f98193p-49; 0x50d27344d071p-45; -0x92b824f1c23bp-48]%float, [0x380155c777565p-47]%float);
(3, [0; 0; 0; 0; 0x199d19e9c07687p-53; 0x199d19e9c07687p-53; 1; 1; 1; 1]%float, 3, 0, 0%float, [0x62946654b1dc7p-49; 0x626d04cd9339p-46; -0x77030e74b6c1fp-48; 0x45747b12280adp-47; 0x76214f084ad09p-48; 0x16967af2f2f2fp-49]%float, [0x62946654b1dc7p-49]%float);
(3, [0; 0; 0; 0; 0x199d19e9c07687p-53; 0x199d19e9c07687p-53; 1; 1; 1; 1]%float, 3, 0, 0x9883b3af9b1bfp-53%float, [-0x2026c16fdfadbp-46; 0xb8ee4e45a2da1p-49; -0x96b45d18156ffp-48; 0x274d27f3217e1p-46; -0x8d426f3b3e185p-48; 0x5566ee51e369p-47]%float, [-0xcc1b2aded456fp-51]%float);
(3, [0; 0; 0; 0; 0x199d19e9c07687p-53; 0x199d19e9c07687p-53; 1; 1; 1; 1]%float, 5, 0, 0x333a33d380ed1p-50%float, [0x339f5274cfb7bp-47; -0x88f60e2f39d61p-48; -0x12ca645d52181p-49; 0x43bd3998baf13p-48; -0x8b1e8dc19dc3fp-49; 0x2f824bda8c603p-49]%float, [0xd1618570f854bp-50]%float);
(3, [0; 0; 0; 0; 0x199d19e9c07687p-53; 0x199d19e9c07687p-53; 1; 1; 1; 1]%float, 5, 0, 0x1d598223c1d4d3p-53%float, [-0xd82477ff7349bp-49; 0x2b63cbbb83979p-47; 0x8d7fdea5302afp-49; 0x2a9cc1a787145p-48; -0x10e4d1eb6cd85p-48; -0x8d5339ac642ebp-49]%float, [-0x5046490dbd31dp-52]%float);
(3, [0; 0; 0; 0; 0x199d19e9c07687p-53; 0x199d19e9c07687p-53; 1; 1; 1; 1]%float, 5, 0, 2%float, [-0xd912c3fefe07p-49; 0x5c4efccca2973p-48; -0x14fe79b27cbed5p-50; 0x298ac557f1f79p-49; 0x6faec916976edp-48; 0xe3ff174a13b5p-45]%float, [0xe3ff174a13b5p-45]%float);
(3, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; 0x7acbf6cc2d8fp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 3, 0, -0x9333333333333p-50%float, [-0xbe22ae3e895d1p-49; 0x8254c2b9d314bp-49; 0x3be395e2b2b7fp-47; 0x3a72560142f7p-45; 0x816ce05f5a275p-49]%float, [-0xbe22ae3e895d1p-49]%float);
(3, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; 0x7acbf6cc2d8fp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 3, 0, -0xa666666666667p-51%float, [-0x3bac593d39bc9p-49; 0xb8700ce216e3p-46; 0x27250b84f39a5p-49; -0x98a7cbeabfa53p-49; -0x140bef4e9dceefp-50]%float, [-0x3bac593d39bc9p-49]%float);
(3, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; 0x7acbf6cc2d8fp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 3, 0, -0x5333333333333p-50%float, [0x94972e6f4c8fbp-49; 0x19f581fa5c751p-46; -0x1e72b0004ba8f7p-50; -0xe260ae853df3p-48; -0x4331097a04d8dp-49]%float, [0x1292e5cde991f7p-50]%float);
(3, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; 0x7acbf6cc2d8fp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 4, 0, 0x7acbf6cc2d8fp-49%float, [-0x2d94fcc33015p-43; -0x1612e253734cdp-46; 0x14dda8d9fd979p-49; 0x32c96d11b8f81p-47; -0x106141b7fc4765p-49]%float, [-0x1dbbdfff9b2dfp-50]%float);
(3, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; 0x7acbf6cc2d8fp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 4, 0, 0xc64fbaf4d7173p-52%float, [-0x13db500bbb1af3p-49; -0x482a3e076f82fp-49; -0x1634bbf7f05bdp-48; -0x55f2635369ac7p-48; -0x48b64ae3f5fc1p-48]%float, [-0xc6a7a18edd79fp-50]%float);
(3, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; 0x7acbf6cc2d8fp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 4, 0, 0x1d8d1a05e16dd7p-52%float, [0xcc091fb5d08fp-49; 0x1698a730ed7a5p-46; 0x19e1ce6acfc51p-48; 0x83160e54d0cf5p-49; 0x2586a22e0d153p-47]%float, [0x41e3ca958e68fp-48]%float);
(3, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; 0x7acbf6cc2d8fp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 4, 0, 0x6cccccccccccdp-49%float, [-0x9813562ed33b1p-48; -0x6de4fa6547d1p-48; -0x1da7639982cf5p-46; -0x72a14917bd83bp-48; -0x72200d9cb3637p-49]%float, [-0x72200d9cb3637p-49]%float);
(3, [0; 0; 0; 0; 0x57d116b4fc877p-453; 0x123fbd09d7e9b7p-453; 0x1a38a3f0dedp-441; 0x3d94b40734dd7p-450; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 3, 0, -1%float, [-0x90741e5f5ec4fp-48; -0xe34a82ac4a7b1p-49; -0x1060027492d28bp-50; 0x29ec8a660aacdp-47; 0x5a8d277ca2ebdp-49; 0x1a28d1a6ed96dp-49; 0x721fdff59a04fp-49; -0x745ae5de81205p-48]%float, [-0x90741e5f5ec4fp-48]%float);
(3, [0; 0; 0; 0; 0x57d116b4fc877p-453; 0x123fbd09d7e9b7p-453; 0x1a38a3f0dedp-441; 0x3d94b40734dd7p-450; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 3, 0, 0x1329281830a43p-453%float, [-0xe64b842d49e8dp-49; -0x794241a715177p-49; 0x66bc8cb576f05p-49; -0x891e7861e585p-48; 0x471ac9a3203b5p-47; -0xb95f8725cc51p-46; -0x665b55d917ed9p-49; 0x439cea09f24b1p-47]%float, [-0x525d741b22029p-48]%float);
(3, [0; 0; 0; 0; 0x57d116b4fc877p-453; 0x123fbd09d7e9b7p-453; 0x1a38a3f0dedp-441; 0x3d94b40734dd7p-450; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 4, 0, 0x669bce56341d9p-453%float, [-0xfb7dfc3f460d7p-49; 0x2d79105ef6511p-47; -0x2bb53d08330c7p-48; 0x8f31cd7d9f017p-48; 0x2b7a726b05893p-48; 0x61919bbb2079bp-48; 0x7eb454ab5213p-44; 0x5f9405004545p-49]%float, [0x1b7cd0ee80ef49p-52]%float);
(3, [0; 0; 0; 0; 0x57d116b4fc877p-453; 0x123fbd09d7e9b7p-453; 0x1a38a3f0dedp-441; 0x3d94b40734dd7p-450; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 6, 0, 0x1eca5a039a6eb7p-453%float, [-0x48e8fa453131p-43; -0x151a06267d183p-48; 0x5543a800a84edp-49; -0xc0b9803467e9p-46; 0x97fd3dc7f7a5dp-48; 0xb0abf249d0a1p-48; -0x11f8df5cb0708fp-49; 0xcfb2b18c46cbp-46]%float, [-0x14c9d9d6e0706dp-50]%float);
(3, [0; 0; 0; 0; 0x57d116b4fc877p-453; 0x123fbd09d7e9b7p-453; 0x1a38a3f0dedp-441; 0x3d94b40734dd7p-450; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 7, 0, 0x1eca5a039a6eb9p-453%float, [-0x16d7f97f393b1p-48; -0x299efc1c30381p-47; -0xcb9aad42fe0afp-49; 0x24635af1cca41p-48; -0x135d328208dd81p-49; 0x299543575453fp-47; 0x8c75a4322ba3p-45; -0x17827bfa896a1p-47]%float, [0x11ac7c8ddde88bp-50]%float);
(3, [0; 0; 0; 0; 0x57d116b4fc877p-453; 0x123fbd09d7e9b7p-453; 0x1a38a3f0dedp-441; 0x3d94b40734dd7p-450; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 7, 0, 0x1p-400%float, [-0x99a3470bd3735p-48; 0x1d9005b666f1p-42; 0x95e14c31dd7c7p-48; 0x1518439f85dd1p-48; 0x115936f97936bp-45; -0xb376f37fc5cb7p-49; -0x1177bc9c7440f9p-49; -0xb2ff1d6e432d1p-50]%float, [-0xb2ff1d6e432d1p-50]%float);
(3, [0; 0; 0; 0; 0x57d116b4fc877p-453; 0x123fbd09d7e9b7p-453; 0x1a38a3f0dedp-441; 0x3d94b40734dd7p-450; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 7, 0, 1%float, [0x840ecb12b435bp-48; -0x292d89bb55379p-47; 0x2019aadf318f7p-49; -0x1fc3ae1defec33p-50; 0xf5f7f0c0d96bp-46; -0x8666e85bfdf41p-48; 0xe1d8d4367b43p-45; 0x68f73e884355p-46]%float, [0x68f73e884355p-46]%float);
(3, [-0x19c9c7b207d535p-53; -0x196a6651b4db2bp-53; -0x122545c9a26599p-53; -0x29b55aa1a7aabp-51; 0x8d5dc5df01dbfp-51; 0x52f2dacc08697p-50; 0xbff971a04673bp-51; 0x6a9f0c531ed81p-50]%float, 3, 0, -0xe7271ec81f54dp-51%float, [-0x11e721385f443p-45; 0xb2929bfb407fp-49; 0x11c11679ad865p-49; -0x7bfa3b3baafdp-46]%float, [-0x1691afc5f24cd9p-50]%float);
(3, [-0x19c9c7b207d535p-53; -0x196a6651b4db2bp-53; -0x122545c9a26599p-53; -0x29b55aa1a7aabp-51; 0x8d5dc5df01dbfp-51; 0x52f2dacc08697p-50; 0xbff971a04673bp-51; 0x6a9f0c531ed81p-50]%float, 3, 0, -0x4ccac696999c5p-52%float, [-0x6e776566eca45p-48; -0xed0ab2cb372c7p-49; 0x9688bdbdd304fp-49; -0x478d771886b1fp-47]%float, [-0x1b2ca448174917p-50]%float);
(3, [-0x19c9c7b207d535p-53; -0x196a6651b4db2bp-53; -0x122545c9a26599p-53; -0x29b55aa1a7aabp-51; 0x8d5dc5df01dbfp-51; 0x52f2dacc08697p-50; 0xbff971a04673bp-51; 0x6a9f0c531ed81p-50]%float, 3, 0, -0x13bfcd4068ff1p-53%float, [0xa7fe08171a8dp-49; -0x2668f2b4517d5p-49; -0x1402a06807bedp-48; 0x24146d8a36985p-46]%float, [-0x2974cfdcb17b7p-50]%float);
(3, [-0x19c9c7b207d535p-53; -0x196a6651b4db2bp-53; -0x122545c9a26599p-53; -0x29b55aa1a7aabp-51; 0x8d5dc5df01dbfp-51; 0x52f2dacc08697p-50; 0xbff971a04673bp-51; 0x6a9f0c531ed81p-50]%float, 3, 0, 0x11abb8bbe03b7dp-52%float, [-0x1b0232650b4375p-50; 0xf1f8933d0cffp-47; -0xee2f4f6bc8843p-49; -0x5f6395645975fp-49]%float, [-0x87e70734e20c9p-49]%float);
(3, [-0x19c9c7b207d535p-53; -0x196a6651b4db2bp-53; -0x122545c9a26599p-53; -0x29b55aa1a7aabp-51; 0x8d5dc5df01dbfp-51; 0x52f2dacc08697p-50; 0xbff971a04673bp-51; 0x6a9f0c531ed81p-50]%float, 3, 0, 0x8d5dc5df01dbfp-51%float, [0x41a81fdf7c8efp-48; 0x98c9412609ad1p-48; 0x2c1bab687ccf1p-48; 0x594fd284d537p-46]%float, [0x798724c4535e3p-50]%float);
(3, [-0x19c9c7b207d535p-53; -0x196a6651b4db2bp-53; -0x122545c9a26599p-53; -0x29b55aa1a7aabp-51; 0x8d5dc5df01dbfp-51; 0x52f2dacc08697p-50; 0xbff971a04673bp-51; 0x6a9f0c531ed81p-50]%float, 3, 0, 0x11abb8bbe03b7fp-52%float, [-0x132da4ead88b9p-49; -0xc798b3ce292f7p-49; -0x295d81aa7260bp-49; 0xafe32de18c9adp-49]%float, [0xd59b16901c84dp-50]%float);
(3, [-0x19c9c7b207d535p-53; -0x196a6651b4db2bp-53; -0x122545c9a26599p-53; -0x29b55aa1a7aabp-51; 0x8d5dc5df01dbfp-51; 0x52f2dacc08697p-50; 0xbff971a04673bp-51; 0x6a9f0c531ed81p-50]%float, 3, 0, 0xaa9f0c531ed81p-50%float, [0x50372e314c6c3p-48; 0x24324f8c5069p-42; 0x66cda6cfc95bdp-48; 0x13725030b701bp-47]%float, [0x76522e1d55dcdp-49]%float);
(4, [0; 0; 0; 0; 0; 0x1p-51; 0x1p-36; 1; 1; 1; 1; 1]%float, 4, 0, -1%float, [-0x1782f513e8fcfp-48; 0x114029f73331bp-45; -0x4c246b248bb0bp-47; 0x419ab672f4ff7p-47; -0x1d16c424f90fp-46; -0x4c42878c8b83bp-48; -0x125adbd7875a67p-50]%float, [-0x1782f513e8fcfp-48]%float);
(4, [0; 0; 0; 0; 0; 0x1p-51; 0x1p-36; 1; 1; 1; 1; 1]%float, 5, 0, 0x1p-51%float, [0x43e15ea247ff9p-48; -0x565fbc363e5a5p-49; 0x378790945f871p-47; -0x61fc791da0cfp-47; 0x1a24b510ecc5p-43; 0x47cd30e79d79p-46; 0x1633d90cc313fp-49]%float, [-0x56588150bd0a3p-49]%float);
(4, [0; 0; 0; 0; 0; 0x1p-51; 0x1p-36; 1; 1; 1; 1; 1]%float, 5, 0, 0x1fffffffffffffp-89%float, [0x90b498156f9d1p-48; 0x28c4b3073b9ddp-47; -0xcd42759ce261p-47; 0x1b875eb61c4bp-48; 0x1fd3e40274f6fp-46; 0x13c2f1a5b3b05p-46; 0x61f6f5f4cf27bp-49]%float, [-0x19a84eb39729ffp-52]%float);
(4, [0; 0; 0; 0; 0; 0x1p-51; 0x1p-36; 1; 1; 1; 1; 1]%float, 6, 0, 0x6d123dd10eeabp-53%float, [-0x2b19e23028f95p-49; -0x18aa296e0fd6bp-49; 0xd9f67c45e9ffp-49; -0x1064d2e52f1b7fp-49; 0x26b46feb59751p-47; 0x6a918f1f9f5c3p-48; -0xf2f639f592abp-48]%float, [-0x11cb89212ed0e5p-51]%float);
(4, [0; 0; 0; 0; 0; 0x1p-51; 0x1p-36; 1; 1; 1; 1; 1]%float, 6, 0, 0x56548b318ae01p-51%float, [0x843f6217edba3p-48; 0x123f0575f3b2bp-48; -0x1ac11a2687ebf7p-50; -0xaa9b6bead59cfp-49; 0x7ed3e851f83dfp-48; -0xd0b4a31f51e25p-49; -0x1f436998179f7p-49]%float, [-0x8b0cb93ba10bbp-51]%float);
(4, [0; 0; 0; 0; 0; 0x1p-51; 0x1p-36; 1; 1; 1; 1; 1]%float, 6, 0, 0x10000000000001p-52%float, [-0x1dc2972d70e73p-48; 0x83bf495c80f4bp-48; 0x16827084a878dp-48; -0x3cd996681092bp-49; 0x2efd6d3c934d7p-48; 0x2d5f5b7b64c51p-47; 0x7ecf898294d69p-48]%float, [0x7ecf898294d69p-48]%float);
(4, [0; 0; 0; 0; 0; 0x1p-51; 0x1p-36; 1; 1; 1; 1; 1]%float, 6, 0, 2%float, [-0x3baab9954db65p-48; -0x9c504d0ff77c7p-48; 0x762aee26719dp-46; -0xbc1f418b9f2f5p-49; -0xff23ea56daf8fp-49; -0x9c94ae224f19fp-48; 0x6bdc96667f7fp-44]%float, [0x6bdc96667f7fp-44]%float);
(4, [0; 0; 0; 0; 0; 0x2dd47ad230c5p-46; 0x16ea3d69186281p-53; 0x16ea3d69186281p-53; 1; 1; 1; 1; 1]%float, 4, 0, -1%float, [0x219aa62cac4b1p-48; 0x953908807b46bp-49; -0xcdad1984301afp-49; 0x6ab95bccfe2abp-48; -0x6f959b615e90bp-49; -0x10c8344a5d9773p-49; 0x1fed41d335511p-48; -0x1f4023af32ff9p-48]%float, [0x219aa62cac4b1p-48]%float);
(4, [0; 0; 0; 0; 0; 0x2dd47ad230c5p-46; 0x16ea3d69186281p-53; 0x16ea3d69186281p-53; 1; 1; 1; 1; 1]%float, 4, 0, 0x1p-1074%float, [-0x2367caa931a6bp-49; -0x81c6bd4fdeab9p-48; -0x9a196182379bbp-48; -0x964757b3e153dp-48; -0x42e9a54ccdbdp-49; 0x44884c4449543p-48; -0x23e663afe7e95p-46; -0xd9d3f61f1291p-46]%float, [-0x2367caa931a6bp-49]%float);
(4, [0; 0; 0; 0; 0; 0x2dd47ad230c5p-46; 0x16ea3d69186281p-53; 0x16ea3d69186281p-53; 1; 1; 1; 1; 1]%float, 4, 0, 0xad6cd4220d67p-51%float, [0x9696868832f65p-48; 0xf01055b692cbp-45; 0x2c71140443107p-48; 0x1807a31824907p-48; -0x1629f4a097524bp-50; 0x23ed012d1a87p-44; -0x1ab99042a90447p-50; -0x7df3c9c185b6dp-49]%float, [0x109f41e91263e9p-49]%float);
(4, [0; 0; 0; 0; 0; 0x2dd47ad230c5p-46; 0x16ea3d69186281p-53; 0x16ea3d69186281p-53; 1; 1; 1; 1; 1]%float, 4, 0, 0x16ea3d6918627fp-53%float, [0x3ec18c8a189ebp-49; -0x91ba3dac507p-45; 0x540e656b2cefp-44; -0x1090832e7b4593p-49; -0xb7510f322548dp-49; -0xaa457a195247bp-50; -0x162153c317699p-47; -0xa420e5a304107p-50]%float, [-0xce8422544713bp-49]%float);
(4, [0; 0; 0; 0; 0; 0x2dd47ad230c5p-46; 0x16ea3d69186281p-53; 0x16ea3d69186281p-53; 1; 1; 1; 1; 1]%float, 7, 0, 0x5cdc0b10a57afp-51%float, [0xc84b93074655p-48; 0x5f3fe979bf48bp-49; 0x4fbd3781ff387p-49; -0x2e7a1ce847d8bp-47; -0xa19f1d679657p-48; -0x82a50f15f2863p-50; -0x95e57e310132fp-49; -0x17b7aab2e44d33p-50]%float, [-0x1ed0bd87a0bdfdp-52]%float);
(4, [0; 0; 0; 0; 0; 0x2dd47ad230c5p-46; 0x16ea3d69186281p-53; 0x16ea3d69186281p-53; 1; 1; 1; 1; 1]%float, 7, 0, 1%float, [-0xf14e7bca8561p-47; -0x8a80a9a6919p-44; -0x5875547c0ca45p-49; -0x667016c4ec9dfp-48; -0xc12c5ae5de985p-49; 0x100487741255p-42; 0x87fc299f49b7dp-48; 0x37086c5db092fp-47]%float, [0x37086c5db092fp-47]%float);
(4, [0; 0; 0; 0; 0; 0x2dd47ad230c5p-46; 0x16ea3d69186281p-53; 0x16ea3d69186281p-53; 1; 1; 1; 1; 1]%float, 7, 0, 2%float, [-0x13bc13050b85p-41; 0x95ed072ab0145p-49; 0x2169ef8c198b3p-46; 0x9dd8f7e4263a5p-48; -0x5a75ca37f1283p-48; 0x4d8c1986b6b37p-49; -0x6f6c1546c77dp-47; 0x58aecddfc123p-45]%float, [0x58aecddfc123p-45]%float);
(4, [0; 0; 0; 0; 0; 0x1ddae00ba91ffp-51; 0x1ddae00ba91ffp-51; 1; 1; 1; 1; 1]%float, 4, 0, -1%float, [-0xc9ac4e2a29627p-49; -0x42ea137ea7101p-49; 0x6bc88280dec5p-44; -0x9cabef599ddf5p-48; 0x78cb180ca21b1p-48; -0xf9ca445a4ac37p-50; 0x5aeaa31a685p-42]%float, [-0xc9ac4e2a29627p-49]%float);
(4, [0; 0; 0; 0; 0; 0x1ddae00ba91ffp-51; 0x1ddae00ba91ffp-51; 1; 1; 1; 1; 1]%float, 4, 0, 0x1ddae00ba91fefp-55%float, [-0x26423d7321c67p-48; -0x21e8e4c06aaf1p-46; -0x17d4ddd1ee9f9p-49; -0xe48c1e2f9ad7p-45; 0x798a1eab2883bp-48; 0x56810882282abp-48; 0x106a3590cd093p-45]%float, [-0x5288aeb545bc7p-49]%float);
(4, [0; 0; 0; 0; 0; 0x1ddae00ba91ffp-51; 0x1ddae00ba91ffp-51; 1; 1; 1; 1; 1]%float, 6, 0, 0x1ddae00ba91ffp-51%float, [-0x4a9559f216acfp-48; 0x766bcb5b59a13p-48; 0x3051a92bf431p-46; 0x83ca07484fe3p-44; 0x7eecce851027fp-48; 0x84c77f0fe9117p-49; -0x84e47c9914d5p-45]%float, [0x1e9297bf4c7073p-51]%float);
(4, [0; 0; 0; 0; 0; 0x1ddae00ba91ffp-51; 0x1ddae00ba91ffp-51; 1; 1; 1; 1; 1]%float, 6, 0, 0x82b588178f14dp-53%float, [0x3e73aa6334b05p-47; -0x1754018338d755p-50; -0x6a3d896e3335p-46; -0xef94557117d6dp-49; 0x3795c5a8a7221p-49; -0x1714e1c5fe309p-49; -0xc13c9fdb6c055p-49]%float, [-0x1dc595a8161945p-51]%float);
(4, [0; 0; 0; 0; 0; 0x1ddae00ba91ffp-51; 0x1ddae00ba91ffp-51; 1; 1; 1; 1; 1]%float, 6, 0, 0x8181e85aea8e1p-52%float, [-0x1a115f3151657p-49; -0x46023d44ebb45p-47; 0x4d4907fc914dp-43; 0x711bc070beca5p-48; -0x5f671edd31addp-49; -0x7bb9c41fa687dp-49; 0x7f8e3e739a79fp-49]%float, [0x1dcc86abebc51fp-52]%float);
(4, [0; 0; 0; 0; 0; 0x1ddae00ba91ffp-51; 0x1ddae00ba91ffp-51; 1; 1; 1; 1; 1]%float, 6, 0, 0x10000000000001p-52%float, [-0xdc8e33cee091bp-49; 0x10e1a94c1c9abp-45; -0x25b1cfd2c4a3fp-46; -0x1e7b50e545cc41p-50; -0x1fb5ee424519p-42; 0xb0042ee5bb5d1p-49; 0x17a932068385p-48]%float, [0x17a932068385p-48]%float);
(4, [0; 0; 0; 0; 0; 0x1ddae00ba91ffp-51; 0x1ddae00ba91ffp-51; 1; 1; 1; 1; 1]%float, 6, 0, 2%float, [0x24855e756d5a1p-48; -0xbe46d78b0001fp-50; 0x124910051e579p-45; 0x4a6d3df5b9859p-48; -0xc28ece172e595p-49; 0x1100fe5e7041p-44; -0x132fb5403d0b33p-49]%float, [-0x132fb5403d0b33p-49]%float);
(4, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x1c7afe1bad419p-51; -0xa7b58e8e9a77p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 4, 0, -0x9333333333333p-50%float, [-0x330d38ae72a11p-48; -0x701f74e339877p-48; -0x4438a2bac72e7p-47; 0xe276f5621083p-48; -0x48581bcd431dbp-47; 0x96ff0cc584fd7p-48; -0x8a6416301f5p-46]%float, [-0x330d38ae72a11p-48]%float);
(4, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x1c7afe1bad419p-51; -0xa7b58e8e9a77p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 4, 0, -0x5333333333333p-50%float, [0x712addfca486fp-49; -0xc65ddcafc65p-45; -0x1067e7d9078459p-50; -0x22e75d171845p-42; 0x140ef6a3029c5p-47; 0x49e341d6c80d7p-47; -0x1ecf7f9bee526fp-50]%float, [0xe255bbf9490dbp-50]%float);
(4, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x1c7afe1bad419p-51; -0xa7b58e8e9a77p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 4, 0, -0x1c7afe1bad4191p-55%float, [-0x2f479d2c655e9p-48; 0x6eac46747dcb9p-48; -0xdc4ee0841e51p-45; -0x7f947f91e9b3p-45; 0x1542f59b22a09p-48; 0x3cb86bf2709b7p-47; 0xb71085d29b45p-48]%float, [-0x28f439777e41fp-47]%float);
(4, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x1c7afe1bad419p-51; -0xa7b58e8e9a77p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 5, 0, -0x1d0224de90eafp-52%float, [0x16e93cbd0ae21p-48; 0x2ca06162e9517p-47; -0x5677e517cc533p-48; -0x69bb1200e2be3p-49; -0x419114de7fb6bp-47; -0xc87a7f2a9d5a7p-49; -0x2848b28f32dcdp-49]%float, [-0x131fe370ac93efp-50]%float);
(4, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x1c7afe1bad419p-51; -0xa7b58e8e9a77p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 6, 0, 0x1a2a4deabba93p-51%float, [0x6abf020ed5523p-48; -0x6a22151daa0b9p-49; 0x88294143e5bbp-44; 0x3101f80e68f67p-48; -0x634d81a60e9d9p-49; -0x1937cfacbacf1p-46; 0x247af23d2d05dp-46]%float, [0x175402ab955f99p-51]%float);
(4, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x1c7afe1bad419p-51; -0xa7b58e8e9a77p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 6, 0, 0x4cccccccccccdp-49%float, [-0x1dfacbd3276b83p-50; 0x908710ff1e51bp-48; -0x38d1893b942afp-47; 0xaa37cced3e8b3p-49; 0x260055b0767cfp-47; 0x556d836576e5p-45; 0x49d7eafb38d89p-49]%float, [0x49d7eafb38d89p-49]%float);
(4, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x1c7afe1bad419p-51; -0xa7b58e8e9a77p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 6, 0, 0x6cccccccccccdp-49%float, [0x8179688cf4d95p-48; -0x108e43a26d85p-41; 0x357267bf688fdp-47; 0x23484ee8613fbp-47; -0x674372f80ccedp-48; 0x67830d7e6f011p-49; 0x4d865205f971p-45]%float, [0x4d865205f971p-45]%float);
(4, [0; 0; 0; 0; 0; 0x64e0fff25b75p-447; 0x1a831ef4800485p-453; 0x1bb7a6b3f705e1p-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 4, 0, -1%float, [-0x88dbe95a83df1p-48; 0x8ee44bd48c17bp-48; -0x1da7a30af95ccdp-50; -0x54131e8e7d57dp-48; 0x71d051046d05fp-49; 0xddb82e80f951p-46; -0x1c3208d77724fp-49; -0x774618fd6f3a5p-49]%float, [-0x88dbe95a83df1p-48]%float);
(4, [0; 0; 0; 0; 0; 0x64e0fff25b75p-447; 0x1a831ef4800485p-453; 0x1bb7a6b3f705e1p-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 4, 0, -0x1p-1074%float, [-0x31cc9d23b8a8bp-48; -0x881aaa7d14c51p-50; 0x287eb6795d8bp-45; 0x277b3c5439337p-47; -0x9a317e43be749p-49; 0x8bfff28cfce3p-47; -0x67ce292e2740fp-49; -0xaeefb55c85d67p-49]%float, [-0x31cc9d23b8a8bp-48]%float);
(4, [0; 0; 0; 0; 0; 0x64e0fff25b75p-447; 0x1a831ef4800485p-453; 0x1bb7a6b3f705e1p-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 4, 0, 0x96605d99055abp-452%float, [-0xd4e510d337003p-49; -0xec4edb756a373p-49; 0x9216d3a277c1dp-49; 0x8cdb2866dca31p-48; -0x114d5dccfad75p-47; 0x277258ff0b183p-46; 0x5cbceac809791p-49; 0x151c4f38432f7p-46]%float, [0x451bc147238f1p-48]%float);
(4, [0; 0; 0; 0; 0; 0x64e0fff25b75p-447; 0x1a831ef4800485p-453; 0x1bb7a6b3f705e1p-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 6, 0, 0x1a831ef4800485p-453%float, [-0x7ca5a5771d72bp-48; -0x9f879a046e3a5p-48; -0x10291e85d48519p-49; -0x4abebe3433de7p-47; -0x2a5012efdaf6bp-49; -0x6256adb033b5dp-48; 0x392044eb9a82bp-47; 0x32f929424627dp-47]%float, [-0xb2a1609200aa9p-50]%float);
(4, [0; 0; 0; 0; 0; 0x64e0fff25b75p-447; 0x1a831ef4800485p-453; 0x1bb7a6b3f705e1p-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 7, 0, 0xed192dac18e69p-452%float, [-0x943d9acbbedb5p-49; -0x9597e5bf36bddp-49; -0x9b9345626f185p-49; -0xaaff68b2cc253p-49; 0xb2d490bbae41p-49; 0x190f1f93181abp-46; -0xf4823c05ebf3dp-50; -0x358c40081fd1p-45]%float, [0x1a0bebed5c7967p-52]%float);
(4, [0; 0; 0; 0; 0; 0x64e0fff25b75p-447; 0x1a831ef4800485p-453; 0x1bb7a6b3f705e1p-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 7, 0, 0x10000000000001p-452%float, [0x2aa344b1e427bp-47; 0x4da9e5bbdee3dp-47; -0xd1276d9bc6e55p-49; 0x30df931468bfp-43; -0x83756c00c37e7p-49; 0x30fdd6c4dd74dp-49; 0x456c0607ecfp-43; 0x2fd43b071ae1fp-49]%float, [0x2fd43b071ae1fp-49]%float);
(4, [0; 0; 0; 0; 0; 0x64e0fff25b75p-447; 0x1a831ef4800485p-453; 0x1bb7a6b3f705e1p-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 7, 0, 1%float, [0xc8da162e16f3p-48; 0x51043b61429dp-46; -0x9c8348b5cd53dp-49; -0xdff7f02455d5p-47; 0x3485d4f4cd65dp-49; 0x47b9ee1397627p-48; 0x7d8b77b9866bbp-48; 0x6f8d344c11387p-48]%float, [0x6f8d344c11387p-48]%float);
(4, [-0xeb12dfa18732fp-52; -0xc6baacade39a3p-52; -0xbbb7ffd452ce7p-52; -0xdbc2861cc84c7p-53; -0x37ed3d6d15aa9p-53; 0xa37ab991b943dp-51; 0x5d4c176f2c903p-50; 0xc83fcb388c781p-51; 0x1c979cb0176cc5p-52; 0x7b344d10ea1e9p-50]%float, 4, 0, -0x1eb12dfa18732fp-52%float, [-0x983008b0c13fp-48; 0xb1de954c8b15p-46; -0x36c8360cb006dp-47; -0x2d08994c99707p-47; 0x325bfb461f441p-47]%float, [0xad5215c752a43p-55]%float);
(4, [-0xeb12dfa18732fp-52; -0xc6baacade39a3p-52; -0xbbb7ffd452ce7p-52; -0xdbc2861cc84c7p-53; -0x37ed3d6d15aa9p-53; 0xa37ab991b943dp-51; 0x5d4c176f2c903p-50; 0xc83fcb388c781p-51; 0x1c979cb0176cc5p-52; 0x7b344d10ea1e9p-50]%float, 4, 0, -0x1bf69eb68ad549p-56%float, [-0x58faa520a651dp-48; -0x171da35faa9d2bp-50; -0x1deb7888486e1p-46; 0x6c5b2871fe7dp-49; -0x62dc730bb2141p-48]%float, [-0xbd16c7aba1afp-45]%float);
(4, [-0xeb12dfa18732fp-52; -0xc6baacade39a3p-52; -0xbbb7ffd452ce7p-52; -0xdbc2861cc84c7p-53; -0x37ed3d6d15aa9p-53; 0xa37ab991b943dp-51; 0x5d4c176f2c903p-50; 0xc83fcb388c781p-51; 0x1c979cb0176cc5p-52; 0x7b344d10ea1e9p-50]%float, 4, 0, -0x1bf69eb68ad547p-56%float, [0x7d7c3280803p-40; -0xd7f2512abdd3bp-49; -0x897dc2abaeb1p-44; 0x64836e023aab9p-48; -0x1caffba8767debp-50]%float, [-0x16d04b0591e36bp-52]%float);
(4, [-0xeb12dfa18732fp-52; -0xc6baacade39a3p-52; -0xbbb7ffd452ce7p-52; -0xdbc2861cc84c7p-53; -0x37ed3d6d15aa9p-53; 0xa37ab991b943dp-51; 0x5d4c176f2c903p-50; 0xc83fcb388c781p-51; 0x1c979cb0176cc5p-52; 0x7b344d10ea1e9p-50]%float, 4, 0, 0x124edc19963ebp-54%float, [0x97a1d92de36c1p-49; 0x396184e770ff1p-48; -0x1664d033045b77p-50; 0xb7a7421c3b053p-49; -0x926022568f657p-48]%float, [0xe24dce5ded7adp-51]%float);
(4, [-0xeb12dfa18732fp-52; -0xc6baacade39a3p-52; -0xbbb7ffd452ce7p-52; -0xdbc2861cc84c7p-53; -0x37ed3d6d15aa9p-53; 0xa37ab991b943dp-51; 0x5d4c176f2c903p-50; 0xc83fcb388c781p-51; 0x1c979cb0176cc5p-52; 0x7b344d10ea1e9p-50]%float, 4, 0, 0x338e677c72f19p-54%float, [0x3fa14d33d48cdp-47; 0x3b6795ba4f55p-46; -0xfcb8a0babd2f7p-50; 0x27c776c39d50bp-46; 0x913439cfe1b59p-49]%float, [0x185ec7492b0f6fp-52]%float);
(4, [-0xeb12dfa18732fp-52; -0xc6baacade39a3p-52; -0xbbb7ffd452ce7p-52; -0xdbc2861cc84c7p-53; -0x37ed3d6d15aa9p-53; 0xa37ab991b943dp-51; 0x5d4c176f2c903p-50; 0xc83fcb388c781p-51; 0x1c979cb0176cc5p-52; 0x7b344d10ea1e9p-50]%float, 4, 0, 0xa37ab991b943dp-51%float, [0x17b1ebc754dc5p-48; 0x19f3db6e49f5bp-46; 0x9b2bbbd6dafp-48; -0x9cc255c3e55e1p-49; -0x11be9dd1f1d143p-50]%float, [-0x11a233424934fp-46]%float);
(4, [-0xeb12dfa18732fp-52; -0xc6baacade39a3p-52; -0xbbb7ffd452ce7p-52; -0xdbc2861cc84c7p-53; -0x37ed3d6d15aa9p-53; 0xa37ab991b943dp-51; 0x5d4c176f2c903p-50; 0xc83fcb388c781p-51; 0x1c979cb0176cc5p-52; 0x7b344d10ea1e9p-50]%float, 4, 0, 0xbb344d10ea1e9p-50%float, [-0x97d370962917p-44; 0x9986c91970c5p-46; -0x3fd2eeb7092e5p-49; 0x834d47a4b2553p-48; -0x11f4c489b8741p-45]%float, [-0xbe4f6e21aea63p-51]%float);
(5, [0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1]%float, 5, 0, -1%float, [-0x30ce8f24ea05dp-47; -0x385bbf227371dp-48; -0x1098202aacb677p-50; 0x124ad90586f01p-45; 0x175874a8ed6c3p-47; -0x14d386d52b257p-49]%float, [-0x30ce8f24ea05dp-47]%float);
(5, [0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1]%float, 5, 0, -0x1p-1074%float, [-0x10fef66617f27p-48; -0xbb0e8ae29b6ebp-49; -0x1363b95242617fp-50; 0x4dfbab49c6ea1p-48; -0x96dc62d9f6b9p-45; 0x190c6166eaefp-49]%float, [-0x10fef66617f27p-48]%float);
(5, [0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1]%float, 5, 0, 0%float, [-0x24321f82cdcfdp-46; -0x729c09af199edp-49; -0x348dc1abc2a1dp-49; -0x15e8a5be2a513bp-50; -0x2571fb2468fbdp-48; 0x7428b286771e9p-49]%float, [-0x24321f82cdcfdp-46]%float);
(5, [0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1]%float, 5, 0, 0x297a21c3b2a71p-52%float, [-0x18f6965c39e5dp-48; 0x9fea372bdd4afp-48; -0x885720adb60a7p-48; 0x4bba9d4b7937fp-47; 0xa861dcdf258dfp-49; -0x11d17af9e7610bp-49]%float, [0x12a0a266a5ae97p-51]%float);
(5, [0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1]%float, 5, 0, 0xe6dd7e8ab669p-49%float, [0xd009cc70f83p-43; -0x13265e30d91c07p-49; -0x156bfd9fb879bp-47; 0x13092fd5664efp-45; 0x61540d8d4818fp-49; 0xa578e5db18165p-49]%float, [0x946f539a639edp-53]%float);
(5, [0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1]%float, 5, 0, 0x10000000000001p-52%float, [0x8cf6a69acc019p-48; 0x208ebecbbc69dp-46; 0x481b31070cc41p-49; 0x396b27da628c7p-49; -0xfe018b1cd019fp-49; -0x4ed52eba75c93p-47]%float, [-0x4ed52eba75c93p-47]%float);
(5, [0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1]%float, 5, 0, 2%float, [-0x9894dc0b2bbcdp-48; 0x9902e59e423p-44; 0x92c05eeeca33fp-48; 0x697828c37abadp-48; 0x11513a42704b5p-49; -0x1b9b3473b6cfd9p-50]%float, [-0x1b9b3473b6cfd9p-50]%float);
(5, [0; 0; 0; 0; 0; 0; 0x15161352f9dcd1p-54; 1; 1; 1; 1; 1; 1]%float, 5, 0, -1%float, [-0x1393d748cd0b3p-46; -0x1346b358c8a3b5p-49; 0x1b848f58cafbbp-48; 0x897ee67dff629p-48; 0x7fa6acab034bbp-48; -0x1f7e91b82109cfp-50; 0x1a44017612783p-47]%float, [-0x1393d748cd0b3p-46]%float);
(5, [0; 0; 0; 0; 0; 0; 0x15161352f9dcd1p-54; 1; 1; 1; 1; 1; 1]%float, 5, 0, 0x4b4521319b501p-52%float, [0x2b0cea7a4bb03p-48; -0x1902ddede2581p-46; -0x13a49993d15949p-49; -0x2d28d75246b0dp-47; -0xd7a78877b5439p-49; 0x4bb21779510fdp-49; -0xa41c6a120237p-47]%float, [-0x1e3e8d1383621bp-50]%float);
(5, [0; 0; 0; 0; 0; 0; 0x15161352f9dcd1p-54; 1; 1; 1; 1; 1; 1]%float, 5, 0, 0x15161352f9dcdp-50%float, [-0x8ef71ea7d3fb7p-49; -0xa6a71b71271b1p-49; -0xa4abfaec39f0dp-49; -0x2d6fb78b9f075p-47; 0xd716f785d439p-46; 0xe64197c3e317p-46; -0x19ec7b95c19ef1p-50]%float, [-0x4654cd090ef1p-44]%float);
(5, [0; 0; 0; 0; 0; 0; 0x15161352f9dcd1p-54; 1; 1; 1; 1; 1; 1]%float, 6, 0, 0x15161352f9dcd1p-54%float, [0x91cdba94ef145p-48; 0x1a90640800cf5p-48; 0x2e7dd069ac051p-48; -0x8bd573159630fp-49; 0xf4fc14ed5b45p-46; 0x7872c919e459p-44; -0xbc99a8cd4514dp-49]%float, [0x1552be9b1a3127p-53]%float);
(5, [0; 0; 0; 0; 0; 0; 0x15161352f9dcd1p-54; 1; 1; 1; 1; 1; 1]%float, 6, 0, 0xe8c2d21a2fec9p-52%float, [0x2e0f0cfb2c4a1p-47; -0xa0774fc0e20d7p-49; -0xfc7565d3374c7p-49; -0x5318318a4b29p-49; -0x64374be799095p-48; -0x16eb9104217d1p-46; -0x114da0b9f8345bp-50]%float, [-0x50ca04143a391p-48]%float);
(5, [0; 0; 0; 0; 0; 0; 0x15161352f9dcd1p-54; 1; 1; 1; 1; 1; 1]%float, 6, 0, 0x10000000000001p-52%float, [0x3307609be2717p-47; 0x29d252887a1dfp-49; 0xc4330abb72c1p-46; -0x428e203a54bffp-48; 0x16046f3975591p-46; 0x49c2d4163f64fp-47; 0x4fefce09408abp-47]%float, [0x4fefce09408abp-47]%float);
(5, [0; 0; 0; 0; 0; 0; 0x15161352f9dcd1p-54; 1; 1; 1; 1; 1; 1]%float, 6, 0, 2%float, [0x54d7a0e46b625p-48; 0x4c168631ca687p-47; 0x4f4897757f00bp-47; 0xa06ca499dc5p-49; -0x1ccb056beae1dfp-50; 0x1548b2262e087p-48; -0x44237ed974d55p-48]%float, [-0x44237ed974d55p-48]%float);
(5, [0; 0; 0; 0; 0; 0; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 1; 1; 1; 1; 1; 1]%float, 5, 0, -1%float, [-0x31bca5d04491p-45; 0x1e79f00105b8bp-48; 0x7c00f5f1caaf7p-48; 0x320c9951fbeabp-47; 0x242464855baa1p-46; -0xc89aa34c491e3p-49; 0x42f40f12a1eb7p-49; 0x43b468887c287p-47; 0x1590200aa5297p-47; -0x22d6fd27629d5p-46; -0x8608f76fb795fp-48; -0x1c8c206933b017p-50]%float, [-0x31bca5d04491p-45]%float);
(5, [0; 0; 0; 0; 0; 0; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 1; 1; 1; 1; 1; 1]%float, 5, 0, -0x1p-1074%float, [-0x37c695b47ca19p-47; -0xc64733c9a44edp-49; -0xa00a9aac5b99p-46; 0x614ee9cad0cf9p-49; -0x1571ea7257ecdp-48; -0x5fbcfa1bd39b7p-48; -0x67b94d84b7493p-49; -0x1ea2588342011p-47; -0xe7eaf67c37a29p-49; 0x38fb2114b50e1p-49; -0x128f4d7f99bf1p-49; -0xdf52c76c1d329p-50]%float, [-0x37c695b47ca19p-47]%float);
(5, [0; 0; 0; 0; 0; 0; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 1; 1; 1; 1; 1; 1]%float, 5, 0, 0%float, [0x934905991ce3dp-49; 0x348d1998e8307p-47; -0x2765a2bad9487p-46; -0x176ffd550ffc0bp-50; -0x11bcf3440dad81p-49; -0x127a8e5a89ff9p-48; 0x17c62fcbb10dp-49; -0xb17e3c5f7ea51p-49; -0x52704b666dd95p-48; -0x8760b48eb38efp-48; -0x9760589b82a15p-48; -0x487a89d70e825p-49]%float, [0x934905991ce3dp-49]%float);
(5, [0; 0; 0; 0; 0; 0; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 1; 1; 1; 1; 1; 1]%float, 5, 0, 0x1p-1074%float, [0x2884156af8dabp-49; 0x1df3cbd8f64b1p-48; 0x288dc71493241p-48; 0x47b072047cbb1p-47; 0xa172f3665153bp-49; 0x27007d4c888ffp-47; -0xd1537b46127e1p-49; 0x106b228e5f9e7p-45; 0x4307d24fff8bfp-47; 0x1a435e5043e93p-46; -0x86286f041421bp-48; 0x447ab27b29f1p-44]%float, [0x2884156af8dabp-49]%float);
(5, [0; 0; 0; 0; 0; 0; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 1; 1; 1; 1; 1; 1]%float, 11, 0, 0xc96fa75f71533p-52%float, [0x20bed606ada2fp-46; -0x7bb6972114a29p-48; 0x267d53c011265p-46; -0x196e9f3a4da8adp-50; 0x1ed09fdc141a1p-48; -0x60f1e54a8cd45p-48; 0x453d1a46e9c7dp-49; -0x19e054873194e1p-50; 0x2579451c4e05bp-46; 0x842fe9083ee41p-48; 0x6b922eb8578dfp-49; 0x2072b9dc87255p-46]%float, [0x17a2414a125183p-50]%float);
(5, [0; 0; 0; 0; 0; 0; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 1; 1; 1; 1; 1; 1]%float, 11, 0, 0x1d9e8b992ea49fp-53%float, [-0x134bb26dc72405p-49; 0x7dee59bf7364dp-48; -0x4f93692f2c4adp-47; 0x1fb603c1b244dp-46; -0x15d530d1d24edp-46; 0x100fecb550f61p-46; 0x6e39ae45c0099p-49; -0xa62eff888b57p-45; 0x3e223f6b28ecfp-48; 0x5a75c1be58a55p-48; 0x130539d05337bp-45; -0x7ad556394719dp-48]%float, [0xd3fcf9ae3b74dp-50]%float);
(5, [0; 0; 0; 0; 0; 0; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 1; 1; 1; 1; 1; 1]%float, 11, 0, 2%float, [-0x31886770aedf7p-49; 0x1b8859dcc4dfp-42; 0x709e77ebd591fp-48; 0x276f3a5d2af79p-46; -0x913ae3c052b6fp-49; 0x2751246dda57dp-48; 0x775c036cf41bp-44; -0x4ef9e84e7a65fp-49; 0x37ab84bf94e49p-49; -0x58224c181941p-44; 0x3911da25cf7p-39; -0x24a968f6f763p-45]%float, [-0x24a968f6f763p-45]%float);
(5, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x21ffea554823fp-49; -0x1d753f0456a1fp-52; 0x12e7af9dbf08bp-51; 0xb2d885b76b8dp-50; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 5, 0, -0x9333333333333p-50%float, [-0x4498bffb8628fp-49; 0x3b6962c261e9bp-47; 0x225dbbe841c99p-47; -0x119a7031b42c17p-49; -0x92959ed6d176bp-48; -0x1a2e86a5f1dbp-45; 0x24144c7caaf11p-46; 0x23ed28b918c2dp-46; 0x7ac4e165fecd1p-49; -0x14e0aefde8b35p-46]%float, [-0x4498bffb8628fp-49]%float);
(5, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x21ffea554823fp-49; -0x1d753f0456a1fp-52; 0x12e7af9dbf08bp-51; 0xb2d885b76b8dp-50; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 6, 0, -0xe3514f88cae55p-52%float, [-0x3b275c73bc70bp-49; 0x5c0b42ec1728bp-49; 0x74657e93807f1p-48; -0x8e2ca110bc759p-48; 0x19799c2c3933dp-47; 0x23250edabe11p-46; -0xf7f6236a0091p-47; -0xf3cf93fbf1f79p-49; -0x8794dd47bef1fp-49; 0x9ffdb1abf532bp-49]%float, [0x84473046e87f7p-51]%float);
(5, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x21ffea554823fp-49; -0x1d753f0456a1fp-52; 0x12e7af9dbf08bp-51; 0xb2d885b76b8dp-50; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 6, 0, -0x101f01832e1405p-53%float, [0x516fba8b122d9p-48; 0x79a76418a20fdp-48; 0x1a171ecba739dp-46; -0xd68012a98a851p-49; 0x79d9508375159p-49; 0x76204b7cbc13p-44; 0x50a66c39281a5p-48; -0x4786ad329429dp-48; 0x4003627d1e6a5p-48; -0x467dd939977a9p-49]%float, [0x5433f1167db47p-50]%float);
(5, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x21ffea554823fp-49; -0x1d753f0456a1fp-52; 0x12e7af9dbf08bp-51; 0xb2d885b76b8dp-50; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 7, 0, -0x1d753f0456a1fp-52%float, [0x93b6d6228eca9p-49; 0x1c2d2bb1b7a55p-47; -0x747a78f3bd32fp-48; 0x2d0eaab1c0c39p-48; -0x119cb5745f74adp-49; -0x17711507a0013p-46; 0x33f7ceea23933p-47; 0x108449c0908a7p-45; -0x4eab5bb27638dp-48; 0xa9389dc2d8633p-49]%float, [-0x1b1cb95b76d507p-50]%float);
(5, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x21ffea554823fp-49; -0x1d753f0456a1fp-52; 0x12e7af9dbf08bp-51; 0xb2d885b76b8dp-50; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 8, 0, 0x12e7af9dbf08b1p-55%float, [-0x1486b00241b3p-49; -0x307eafbd091c5p-48; -0x428e6c09e493dp-47; -0x2ac48f4088e51p-49; 0x10a2c60864363p-48; 0x3832f723455e1p-47; -0x3f8d0917a4dbp-43; -0x87ec485c64b37p-49; -0x9eb28046c0b2fp-48; -0x2ea07dd0976cdp-47]%float, [0x15186cf9ffe123p-51]%float);
(5, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x21ffea554823fp-49; -0x1d753f0456a1fp-52; 0x12e7af9dbf08bp-51; 0xb2d885b76b8dp-50; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 8, 0, 0x165b10b6ed719fp-55%float, [0x666a38e1011cdp-48; 0x8c62419089089p-48; -0xb6635c39325e5p-49; -0xb5105397b009p-49; 0xf313bfbfd313p-49; -0x5e289ebdbf13p-49; 0x24bd54d59a061p-46; 0x900700e0a5fa9p-48; -0x93ac5cd39bf19p-48; -0x3ad4839c60129p-49]%float, [0x197d191ae666edp-52]%float);
(5, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x21ffea554823fp-49; -0x1d753f0456a1fp-52; 0x12e7af9dbf08bp-51; 0xb2d885b76b8dp-50; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 9, 0, 0x6cccccccccccdp-49%float, [0x5fffc39b9bc93p-49; 0x9b402c0a9fbdp-48; 0x66743118fa639p-48; -0x100e9f76ba35e1p-49; -0xc6bcf02ebcb5p-48; 0x1a6e55c895a83p-46; -0x34b073b4d8b69p-47; -0x1a1b639b0163cbp-50; 0x4a8e4ccb7fba7p-49; -0x71949f5b57bf9p-48]%float, [-0x71949f5b57bf9p-48]%float);
(5, [0; 0; 0; 0; 0; 0; 0x3c0592ea96dfbp-451; 0x6392decfade31p-451; 0x6f0df86b02d35p-451; 0x1c84c9922bf16fp-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 5, 0, -1%float, [0x707f2d3cf98ddp-48; 0x53e3377795c1p-48; -0x4b98332d5091p-43; 0x24322877a97ffp-47; -0x11d0ab50f1b67p-45; 0x4e11f92855383p-48; -0x910ca31dc77a1p-49; 0x312d1ddbef5cfp-47; -0x385b52b0f3dd1p-48; 0x3fabfdaf9e7a9p-49]%float, [0x707f2d3cf98ddp-48]%float);
(5, [0; 0; 0; 0; 0; 0; 0x3c0592ea96dfbp-451; 0x6392decfade31p-451; 0x6f0df86b02d35p-451; 0x1c84c9922bf16fp-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 5, 0, 0x27564c632ffdp-447%float, [0x5250a44a5ed13p-49; -0x114f0ea7275ccbp-49; -0xa020df44bfc3p-45; 0x1b7bfbb49ccdfp-48; 0x123bf590b374dp-45; 0x412333ecddacbp-48; -0x11d3a71e8a95a3p-49; 0x627c57fa04b59p-48; -0xb821909a0c863p-49; 0xf44a110fbc43p-47]%float, [-0x12585591c5c3cbp-51]%float);
(5, [0; 0; 0; 0; 0; 0; 0x3c0592ea96dfbp-451; 0x6392decfade31p-451; 0x6f0df86b02d35p-451; 0x1c84c9922bf16fp-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 6, 0, 0x1e02c9754b6fd9p-454%float, [-0x8c57f7d776c59p-48; 0x5741e67359e49p-48; -0x121b2400462bp-46; 0x218fc4adfdabbp-48; 0x83102743d8105p-49; 0x1e09ab19f54c7p-48; -0x356f4dda898bp-45; -0x720335e2e321p-45; 0x133df209424fp-45; -0xa28e12c79d37bp-49]%float, [0x12c7b50b63fdf5p-51]%float);
(5, [0; 0; 0; 0; 0; 0; 0x3c0592ea96dfbp-451; 0x6392decfade31p-451; 0x6f0df86b02d35p-451; 0x1c84c9922bf16fp-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 6, 0, 0x8aa67226a6999p-452%float, [-0x327f29d417c69p-48; 0x8d725188fc64fp-49; 0x72e33a262d9e1p-49; -0x16240e45ba1cbp-49; 0x5b5b8530792ebp-48; -0x6c8bec43f6069p-49; -0x13dae41aedd049p-49; 0x37c14a1c06a2bp-47; 0x4fcfc4700c385p-48; 0x9885732f1f5c9p-49]%float, [0x1fceffd0185d39p-52]%float);
(5, [0; 0; 0; 0; 0; 0; 0x3c0592ea96dfbp-451; 0x6392decfade31p-451; 0x6f0df86b02d35p-451; 0x1c84c9922bf16fp-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 6, 0, 0x18e4b7b3eb78c3p-453%float, [0x8fbd55b90c937p-48; -0xca646efbf44bp-47; -0x6a0c5c28e69dp-47; 0xa2631c19f401p-47; -0xd349ac8d4e69p-47; 0x80918ba648ed9p-48; -0x279833917509bp-46; -0x12e0e7d8e9befp-45; 0x9db4a8ce7cbb9p-48; 0x22dddbc9d0091p-48]%float, [0x14efcfe4b30b5p-47]%float);
(5, [0; 0; 0; 0; 0; 0; 0x3c0592ea96dfbp-451; 0x6392decfade31p-451; 0x6f0df86b02d35p-451; 0x1c84c9922bf16fp-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 7, 0, 0x6392decfade31p-451%float, [-0x5aea0d3211fd3p-48; 0x335d2be5d80e1p-47; 0x3dfd7ff1e5631p-47; 0x824479314699p-47; -0x1070d1a8cc5f0bp-50; 0x82b26e2d8f211p-48; -0x24099bdae3b53p-46; -0xc89d3e93ef43dp-50; 0x23d13a5dfbe73p-47; -0x198cabb899ded7p-50]%float, [0x98ad7c6f2c44fp-50]%float);
(5, [0; 0; 0; 0; 0; 0; 0x3c0592ea96dfbp-451; 0x6392decfade31p-451; 0x6f0df86b02d35p-451; 0x1c84c9922bf16fp-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 9, 0, 1%float, [-0x137ee9b35f0cf1p-50; -0x647b9570119fp-49; 0x101f0e3a66c83p-48; 0x5755018579069p-48; -0x971660987a8fdp-49; 0x2a57421a0becdp-49; 0x17fa47da56e5p-46; 0x1c29127c789fdp-48; 0x8e0b2094e953p-47; -0x15aa01d7847fp-44]%float, [-0x15aa01d7847fp-44]%float);
(5, [-0xe91c1c60882d9p-52; -0xe8d5bfeb22badp-52; -0x1527dd303cb017p-53; -0xd9edfad6d173bp-53; -0x3f289a91aac8fp-52; -0x2e15fbf703cb9p-52; 0xb88eaec535255p-53; 0x10a82668a78c3p-48; 0x4bf4bde288ac7p-50; 0x9d1c4d863f667p-51; 0x19439c75c978ddp-52; 0xe5783c5d8ddd3p-51; 0x7ddcbe3a744b5p-50]%float, 5, 0, -0x1e91c1c60882d9p-52%float, [-0x10a670b80647fp-45; -0x10ccae790731d1p-49; 0x824104c4e4437p-48; -0x1c045984ef6403p-50; -0x3957cf084103dp-48; -0xa7151c2b7f85p-49; 0x3b99936da4bbp-43]%float, [-0x92173f1e73191p-49]%float);
(5, [-0xe91c1c60882d9p-52; -0xe8d5bfeb22badp-52; -0x1527dd303cb017p-53; -0xd9edfad6d173bp-53; -0x3f289a91aac8fp-52; -0x2e15fbf703cb9p-52; 0xb88eaec535255p-53; 0x10a82668a78c3p-48; 0x4bf4bde288ac7p-50; 0x9d1c4d863f667p-51; 0x19439c75c978ddp-52; 0xe5783c5d8ddd3p-51; 0x7ddcbe3a744b5p-50]%float, 5, 0, -0x170afdfb81e5c9p-55%float, [-0x10c50b9d46bc91p-49; -0x1bc3196feeb1bp-48; -0x1ecb67fe8fb5bp-49; 0x6e83585eee625p-48; -0x4a6fa0cb413b5p-48; 0x852e465f8b427p-48; 0x6468494352447p-48]%float, [-0x9851c9852c003p-50]%float);
(5, [-0xe91c1c60882d9p-52; -0xe8d5bfeb22badp-52; -0x1527dd303cb017p-53; -0xd9edfad6d173bp-53; -0x3f289a91aac8fp-52; -0x2e15fbf703cb9p-52; 0xb88eaec535255p-53; 0x10a82668a78c3p-48; 0x4bf4bde288ac7p-50; 0x9d1c4d863f667p-51; 0x19439c75c978ddp-52; 0xe5783c5d8ddd3p-51; 0x7ddcbe3a744b5p-50]%float, 5, 0, -0x743db3e9d5aa3p-55%float, [0x1e445cc7cbb49p-49; 0x34ffff62a77fp-43; -0xb303119b0a6dp-46; -0xca2b12e3fca5p-47; 0x9ed474f0233bp-45; 0x43f1335246aa3p-49; -0x10adbb85f49099p-49]%float, [0x1054f455442767p-51]%float);
(5, [-0xe91c1c60882d9p-52; -0xe8d5bfeb22badp-52; -0x1527dd303cb017p-53; -0xd9edfad6d173bp-53; -0x3f289a91aac8fp-52; -0x2e15fbf703cb9p-52; 0xb88eaec535255p-53; 0x10a82668a78c3p-48; 0x4bf4bde288ac7p-50; 0x9d1c4d863f667p-51; 0x19439c75c978ddp-52; 0xe5783c5d8ddd3p-51; 0x7ddcbe3a744b5p-50]%float, 6, 0, 0xb88eaec535255p-53%float, [-0x130e6b8edd197fp-50; -0x979c9f5c52cc5p-48; 0x64207946a17d3p-48; 0x96b38801548b7p-48; 0x3274d3b8f603bp-48; 0xb200deb8f889bp-49; -0x41e2f147c1b11p-49]%float, [0xc4b03b53e8109p-49]%float);
(5, [-0xe91c1c60882d9p-52; -0xe8d5bfeb22badp-52; -0x1527dd303cb017p-53; -0xd9edfad6d173bp-53; -0x3f289a91aac8fp-52; -0x2e15fbf703cb9p-52; 0xb88eaec535255p-53; 0x10a82668a78c3p-48; 0x4bf4bde288ac7p-50; 0x9d1c4d863f667p-51; 0x19439c75c978ddp-52; 0xe5783c5d8ddd3p-51; 0x7ddcbe3a744b5p-50]%float, 6, 0, 0x1711d5d8a6a4abp-54%float, [0x62bed34c40039p-48; -0x9428706f8b033p-49; -0x9f5b7cc1315f9p-50; -0x24b538abfd7d7p-47; -0x4b437670b7959p-48; 0x3a997fd9c178fp-47; -0x9dcc49580a9b5p-48]%float, [-0x1d8fa39fe53ab7p-51]%float);
(5, [-0xe91c1c60882d9p-52; -0xe8d5bfeb22badp-52; -0x1527dd303cb017p-53; -0xd9edfad6d173bp-53; -0x3f289a91aac8fp-52; -0x2e15fbf703cb9p-52; 0xb88eaec535255p-53; 0x10a82668a78c3p-48; 0x4bf4bde288ac7p-50; 0x9d1c4d863f667p-51; 0x19439c75c978ddp-52; 0xe5783c5d8ddd3p-51; 0x7ddcbe3a744b5p-50]%float, 6, 0, 0x910843b0202ebp-52%float, [-0xca3e4415eb6d7p-49; 0x16c7c086c6b43p-46; 0x2cd7c04f3d8dp-45; 0x292c5c5192bf9p-47; 0x1f531e2abc02fp-47; 0x3e1d181bc78cdp-47; 0x1bbd885d0deefp-48]%float, [0x11d9f83a370501p-50]%float);
(5, [-0xe91c1c60882d9p-52; -0xe8d5bfeb22badp-52; -0x1527dd303cb017p-53; -0xd9edfad6d173bp-53; -0x3f289a91aac8fp-52; -0x2e15fbf703cb9p-52; 0xb88eaec535255p-53; 0x10a82668a78c3p-48; 0x4bf4bde288ac7p-50; 0x9d1c4d863f667p-51; 0x19439c75c978ddp-52; 0xe5783c5d8ddd3p-51; 0x7ddcbe3a744b5p-50]%float, 6, 0, 0xbddcbe3a744b5p-50%float, [-0xfe85eb1c1e11dp-49; -0x1c3b9a75ae7efp-48; -0xf4360281a106fp-49; -0x798e8534ee71bp-49; -0x120738b5fd6e2dp-50; 0x4d57ac841f185p-47; 0x94aff9314369bp-48]%float, [0x31c0776341f1fp-47]%float)]%nat.

Definition insertions : list (nat * list float * nat * nat * float * list float * list float) := [
(1, [0; 0; 0x1p-59; 0x1p-53; 0x1p-32; 0x1p-27; 1; 1]%float, 1, 2, 0x1fffffffffffffp-112%float, [0x713a1ce453513p-48; -0x13df92f5f0c87p-46; -0xb82e11ef74b35p-49; -0x9490a270c0789p-48; 0x39ffaffe55d73p-48; 0x4ff47b5c9d075p-47]%float, [0x713a1ce453513p-48; -0x9efc97af86437p-49; -0x9efc97af86437p-49; -0x13df92f5f0c87p-46; -0xb82e11ef74b35p-49; -0x9490a270c0789p-48; 0x39ffaffe55d73p-48; 0x4ff47b5c9d075p-47]%float);
(1, [0; 0; 0x1p-59; 0x1p-53; 0x1p-32; 0x1p-27; 1; 1]%float, 3, 1, 0x10000000000001p-105%float, [0x184b26733ae93p-46; 0x1cd1cc99f2bcfp-46; 0xb9b3917e73dp-46; -0x51e1a42477411p-49; 0x8b6d8051cb4e9p-48; 0xa95a42bac9p-44]%float, [0x184b26733ae93p-46; 0x1cd1cc99f2bcfp-46; 0xb9b3917e73dp-46; 0xb9b3917e73dp-46; -0x51e1a42477411p-49; 0x8b6d8051cb4e9p-48; 0xa95a42bac9p-44]%float);
(1, [0; 0; 0x1p-59; 0x1p-53; 0x1p-32; 0x1p-27; 1; 1]%float, 5, 1, 0x48beab12cd75dp-52%float, [-0xae0fc0959df2bp-50; 0x8a30dea4bd153p-48; 0x827ae397335a5p-48; -0x30e39428a826fp-49; 0x7ae691bd07b55p-48; -0x1ad746ee6517fp-46]%float, [-0xae0fc0959df2bp-50; 0x8a30dea4bd153p-48; 0x827ae397335a5p-48; -0x30e39428a826fp-49; 0x7ae691bd07b55p-48; 0x72f011dad3fb1p-49; -0x1ad746ee6517fp-46]%float);
(1, [0; 0; 0x1p-59; 0x1p-53; 0x1p-32; 0x1p-27; 1; 1]%float, 5, 1, 0x1f26838f87a893p-53%float, [-0xac6a0ece1763p-45; -0xcee632c5fd12bp-49; -0x1a1ce6fea20e01p-50; 0x340db0468b13p-48; -0x59cc29101af5fp-49; 0x4655e2afaac1p-48]%float, [-0xac6a0ece1763p-45; -0xcee632c5fd12bp-49; -0x1a1ce6fea20e01p-50; 0x340db0468b13p-48; -0x59cc29101af5fp-49; 0xc595b5d934c3fp-54; 0x4655e2afaac1p-48]%float);
(1, [0; 0; 0x158a064de1bf69p-53; 0xac50326f0dfb5p-52; 0x158a064de1bf6bp-53; 1; 1]%float, 1, 2, 0xbbf7a7a31f84dp-53%float, [0x33bd48cb5064bp-48; -0x1cffca080621dp-49; 0x81043b4270c3bp-48; -0xbf021c852accfp-50; 0x48488414d02fp-44]%float, [0x33bd48cb5064bp-48; 0xf9c70e71b1b3fp-52; 0xf9c70e71b1b3fp-52; -0x1cffca080621dp-49; 0x81043b4270c3bp-48; -0xbf021c852accfp-50; 0x48488414d02fp-44]%float);
(1, [0; 0; 0x158a064de1bf69p-53; 0xac50326f0dfb5p-52; 0x158a064de1bf6bp-53; 1; 1]%float, 1, 2, 0xaa2ca1a58946dp-52%float, [-0x8920deb4a077p-49; -0x59053df2604abp-48; -0xe06d099da68edp-50; 0x7fb9d132cd573p-49; -0xd5b72489dd433p-49]%float, [-0x8920deb4a077p-49; -0xafeff3c1c945p-45; -0xafeff3c1c945p-45; -0x59053df2604abp-48; -0xe06d099da68edp-50; 0x7fb9d132cd573p-49; -0xd5b72489dd433p-49]%float);
(1, [0; 0; 0x158a064de1bf69p-53; 0xac50326f0dfb5p-52; 0x158a064de1bf6bp-53; 1; 1]%float, 2, 1, 0x158a064de1bf69p-53%float, [0x575ada9c74825p-48; -0x33cc751cf097p-47; -0xfbc7b906d277p-46; 0x2fe1a4c61fc61p-47; 0x34f889ee15c1p-43]%float, [0x575ada9c74825p-48; -0x33cc751cf097p-47; -0x33cc751cf097p-47; -0xfbc7b906d277p-46; 0x2fe1a4c61fc61p-47; 0x34f889ee15c1p-43]%float);
(1, [0; 0; 0x158a064de1bf69p-53; 0xac50326f0dfb5p-52; 0x158a064de1bf6bp-53; 1; 1]%float, 3, 1, 0xac50326f0dfb5p-52%float, [-0x786b6d05868e7p-49; -0xbaff0568e3323p-49; 0x79c544d53ee9p-49; 0x4576f669af445p-47; 0x13b8f01da4323p-47]%float, [-0x786b6d05868e7p-49; -0xbaff0568e3323p-49; 0x79c544d53ee9p-49; 0x79c544d53ee9p-49; 0x4576f669af445p-47; 0x13b8f01da4323p-47]%float);
(1, [0; 0; 0x158a064de1bf69p-53; 0xac50326f0dfb5p-52; 0x158a064de1bf6bp-53; 1; 1]%float, 4, 1, 0x5628193786fdbp-51%float, [0x12137100158f5p-46; 0x104e5f821346bp-45; -0xc58093803c091p-49; 0x139526730fc3p-42; -0x11a64f1420bfb5p-49]%float, [0x12137100158f5p-46; 0x104e5f821346bp-45; -0xc58093803c091p-49; 0x139526730fc3p-42; 0x139526730fc2fbp-50; -0x11a64f1420bfb5p-49]%float);
(1, [0; 0; 0xad3bf7c68cb73p-54; 0x1720cd30861a05p-53; 1; 1]%float, 2, 2, 0x277de46b410d9p-51%float, [-0x1ec83b38745225p-50; -0x114d2463df8f0bp-49; -0x92eb8e02d2b41p-48; 0x42fb16106c43p-43]%float, [-0x1ec83b38745225p-50; -0x114d2463df8f0bp-49; -0x1191b0a98454d5p-49; -0x1191b0a98454d5p-49; -0x92eb8e02d2b41p-48; 0x42fb16106c43p-43]%float);
(1, [0; 0; 0xad3bf7c68cb73p-54; 0x1720cd30861a05p-53; 1; 1]%float, 2, 2, 0x78255d61643f7p-52%float, [-0x771bad8f77405p-48; 0x45c1236f24721p-47; 0x12c8703dd65f1p-46; 0x1d8e97eea3a7p-46]%float, [-0x771bad8f77405p-48; 0x45c1236f24721p-47; 0x344d57e2c60bbp-47; 0x344d57e2c60bbp-47; 0x12c8703dd65f1p-46; 0x1d8e97eea3a7p-46]%float);
(1, [0; 0; 0xad3bf7c68cb73p-54; 0x1720cd30861a05p-53; 1; 1]%float, 3, 1, 0x1720cd30861a05p-53%float, [0x1ca06b51b9f7fp-48; 0xbc42d57f333b5p-49; -0xa1640623e2ea9p-49; 0x96a959717365p-44]%float, [0x1ca06b51b9f7fp-48; 0xbc42d57f333b5p-49; -0xa1640623e2ea9p-49; -0xa1640623e2ea9p-49; 0x96a959717365p-44]%float);
(1, [0; 0; 0xad3bf7c68cb73p-54; 0x1720cd30861a05p-53; 1; 1]%float, 3, 1, 0x1fffffffffffffp-53%float, [0x46277c684e06bp-47; 0x28e1cb3db2c95p-48; 0x9e83a1090c97dp-49; -0x88f1655505dcbp-49]%float, [0x46277c684e06bp-47; 0x28e1cb3db2c95p-48; 0x9e83a1090c97dp-49; -0x88f1655505dc9p-49; -0x88f1655505dcbp-49]%float);
(1, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x156e3f69813adfp-53; 0x14024177e9619p-51; 0x8eeb9ce144f63p-52; 0xe5104a0474be3p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 1, 1, -0xab71fb4c09d7p-48%float, [0x4bca30d1e519p-48; -0x1c7e5f61416cddp-50; 0x931d2dc5a45cdp-48; -0x1345b48b61b23fp-50; 0x21f1e79ed3ccdp-48; -0x19ada02dde0efp-48]%float, [0x4bca30d1e519p-48; -0x1c7e5f61416cdbp-50; -0x1c7e5f61416cddp-50; 0x931d2dc5a45cdp-48; -0x1345b48b61b23fp-50; 0x21f1e79ed3ccdp-48; -0x19ada02dde0efp-48]%float);
(1, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x156e3f69813adfp-53; 0x14024177e9619p-51; 0x8eeb9ce144f63p-52; 0xe5104a0474be3p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 4, 1, 0xba9610f1e3c05p-52%float, [0x6d28c3148adffp-49; -0x9e19e66d50c4bp-49; -0xebb5f5331b573p-49; -0xd2bebf88548afp-49; -0xeea4c4698d33p-48; -0x55ded103ab6d1p-48]%float, [0x6d28c3148adffp-49; -0x9e19e66d50c4bp-49; -0xebb5f5331b573p-49; -0xd2bebf88548afp-49; -0xee1469537e39fp-50; -0xeea4c4698d33p-48; -0x55ded103ab6d1p-48]%float);
(1, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x156e3f69813adfp-53; 0x14024177e9619p-51; 0x8eeb9ce144f63p-52; 0xe5104a0474be3p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 5, 2, 0x1ca209408e97c7p-53%float, [0x278fe07477b5p-42; -0x1566ef8cdc7fdp-46; -0x2364c4da1dbe7p-49; -0x9f80147990cf5p-49; 0x1d3229d120cdp-44; 0x27bb84dfa9d0dp-48]%float, [0x278fe07477b5p-42; -0x1566ef8cdc7fdp-46; -0x2364c4da1dbe7p-49; -0x9f80147990cf5p-49; 0x1d3229d120cdp-44; 0x1d3229d120cdp-44; 0x1d3229d120cdp-44; 0x27bb84dfa9d0dp-48]%float);
(1, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x156e3f69813adfp-53; 0x14024177e9619p-51; 0x8eeb9ce144f63p-52; 0xe5104a0474be3p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 5, 1, 0x86ad2cfe43bb5p-50%float, [-0x4de2912c9e197p-48; -0x3144e849b376bp-49; 0x8617aee06f0dp-48; -0x9e74c101f493fp-48; -0x12947c6c138437p-49; -0x3a6a43832e5f3p-49]%float, [-0x4de2912c9e197p-48; -0x3144e849b376bp-49; 0x8617aee06f0dp-48; -0x9e74c101f493fp-48; -0x12947c6c138437p-49; -0xd2ac852c46231p-50; -0x3a6a43832e5f3p-49]%float);
(1, [0; 0; 0x41c34515804f9p-451; 0x127d4b8969c0b3p-453; 0x1e7a9ce363ccdp-449; 0x1p-400; 0x1p-400]%float, 2, 1, 0x93ea5c4b4e059p-452%float, [0x928410007c837p-49; -0xa9a42bf7ceefp-47; 0x75c6141b4affp-49; 0xcf8e2afd3acfp-47; -0x8f9ad98cbe15bp-48]%float, [0x928410007c837p-49; -0xa9a42bf7ceefp-47; 0xeb8c283695fafp-54; 0x75c6141b4affp-49; 0xcf8e2afd3acfp-47; -0x8f9ad98cbe15bp-48]%float);
(1, [0; 0; 0x41c34515804f9p-451; 0x127d4b8969c0b3p-453; 0x1e7a9ce363ccdp-449; 0x1p-400; 0x1p-400]%float, 3, 2, 0x9be3cedea0b25p-452%float, [0x434c71e1e0303p-47; 0x6881c7c03660fp-49; -0x6768ef95a46bp-48; -0x13387ec967695fp-49; 0x936a150cdba6dp-48]%float, [0x434c71e1e0303p-47; 0x6881c7c03660fp-49; -0x6768ef95a46bp-48; -0x12b5b12bd97ee3p-52; -0x12b5b12bd97ee3p-52; -0x13387ec967695fp-49; 0x936a150cdba6dp-48]%float);
(1, [0; 0; 0x41c34515804f9p-451; 0x127d4b8969c0b3p-453; 0x1e7a9ce363ccdp-449; 0x1p-400; 0x1p-400]%float, 3, 1, 0x17573f0c05d89dp-453%float, [-0x10d562c91896fp-46; 0x26ae82f75310bp-46; -0x1471980dd5a27p-47; -0x99e7017d06afdp-48; 0x1da6533c3ebdfp-47]%float, [-0x10d562c91896fp-46; 0x26ae82f75310bp-46; -0x1471980dd5a27p-47; -0xad3bfca30f0b9p-49; -0x99e7017d06afdp-48; 0x1da6533c3ebdfp-47]%float);
(1, [0; 0; 0x41c34515804f9p-451; 0x127d4b8969c0b3p-453; 0x1e7a9ce363ccdp-449; 0x1p-400; 0x1p-400]%float, 4, 1, 0x1e7a9ce363ccdp-449%float, [-0xf86b5c6041e3fp-50; 0x6cfee8cf03753p-48; 0x373914010408bp-48; -0x4d7c061fc2403p-47; -0xf8b63e599b1dp-48]%float, [-0xf86b5c6041e3fp-50; 0x6cfee8cf03753p-48; 0x373914010408bp-48; -0x4d7c061fc2403p-47; -0x4d7c061fc2403p-47; -0xf8b63e599b1dp-48]%float);
(1, [-0x109b9793e6667p-50; -0x30dc351bdd305p-52; 0xc89da11b6c209p-52; 0x6905aeaf463b3p-51; 0xe2dcaa3e07db9p-52; 0x184c81998e07p-44; 0x18fb526269355dp-52]%float, 1, 1, 0x19130d3895e77bp-53%float, [0x4ba2ef74bb97p-45; -0x97aec10e9599p-48; -0x1245d50661e589p-49; 0x1076db56fac03p-46; -0x85eb0dc364aadp-49]%float, [0x4ba2ef74bb97p-45; -0x12f3ddcbac1cbbp-53; -0x97aec10e9599p-48; -0x1245d50661e589p-49; 0x1076db56fac03p-46; -0x85eb0dc364aadp-49]%float);
(1, [-0x109b9793e6667p-50; -0x30dc351bdd305p-52; 0xc89da11b6c209p-52; 0x6905aeaf463b3p-51; 0xe2dcaa3e07db9p-52; 0x184c81998e07p-44; 0x18fb526269355dp-52]%float, 4, 1, 0xe2dcaa3e07db9p-52%float, [0x2fcba8137f8d5p-47; -0x49f03b1ca1c6bp-48; 0x10d59b054372fp-49; -0xe5ca5066fae7p-49; 0x48c062028eeadp-47]%float, [0x2fcba8137f8d5p-47; -0x49f03b1ca1c6bp-48; 0x10d59b054372fp-49; -0xe5ca5066fae7p-49; -0xe5ca5066fae7p-49; 0x48c062028eeadp-47]%float);
(1, [-0x109b9793e6667p-50; -0x30dc351bdd305p-52; 0xc89da11b6c209p-52; 0x6905aeaf463b3p-51; 0xe2dcaa3e07db9p-52; 0x184c81998e07p-44; 0x18fb526269355dp-52]%float, 4, 1, 0x1c5b9547c0fb73p-53%float, [0x1ae164e6cd5f5p-46; -0x82123d906d1f1p-49; -0x1578458a6f9e03p-50; -0x1cb2ee411a29p-47; -0x133f60ec83afp-42]%float, [0x1ae164e6cd5f5p-46; -0x82123d906d1f1p-49; -0x1578458a6f9e03p-50; -0x1cb2ee411a29p-47; -0x72cbb90468a47p-53; -0x133f60ec83afp-42]%float);
(1, [-0x109b9793e6667p-50; -0x30dc351bdd305p-52; 0xc89da11b6c209p-52; 0x6905aeaf463b3p-51; 0xe2dcaa3e07db9p-52; 0x184c81998e07p-44; 0x18fb526269355dp-52]%float, 4, 2, 0x14be4848c8bac5p-52%float, [0x1b7cf9bd1cae5p-48; 0x65b689df07b0dp-48; -0x10297fe1a4ea57p-49; -0xb83f2ae3d1893p-50; 0x27d1e12573e05p-46]%float, [0x1b7cf9bd1cae5p-48; 0x65b689df07b0dp-48; -0x10297fe1a4ea57p-49; -0xb83f2ae3d1893p-50; 0x15c89e63ac7f1fp-50; 0x15c89e63ac7f1fp-50; 0x27d1e12573e05p-46]%float);
(2, [0; 0; 0; 0x1p-60; 1; 1; 1]%float, 2, 1, 0x1fffffffffffffp-113%float, [-0x6d2cb3fce47p-41; -0x68ca4c6b0a4b3p-48; -0x8853d52708cd1p-49; -0x6e12fe6a5d40dp-48]%float, [-0x6d2cb3fce47p-41; -0x1a32931ac292cbp-50; -0x68ca4c6b0a4b3p-48; -0x8853d52708cd1p-49; -0x6e12fe6a5d40dp-48]%float);
(2, [0; 0; 0; 0x1p-60; 1; 1; 1]%float, 3, 2, 0x10000000000001p-112%float, [-0x36c521235706bp-48; -0x50729bbb62aa1p-48; 0x488799a4a59p-44; -0xd37a520868845p-49]%float, [-0x36c521235706bp-48; -0x50729bbb62aa1p-48; -0x50729bbb62aa1p-48; -0x50729bbb62aa1p-48; 0x488799a4a59p-44; -0xd37a520868845p-49]%float);
(2, [0; 0; 0; 0x1p-60; 1; 1; 1]%float, 3, 3, 0x350bdcd58989p-47%float, [0x4794ed3a108b3p-47; -0xa9f431ffaabbfp-49; 0xefa8deff9c53p-45; -0xb50d4862bfde3p-50]%float, [0x4794ed3a108b3p-47; -0xa9f431ffaabbfp-49; -0xcccb14d2a85p-51; 0x153f5fe87d0941p-52; 0x153f5fe87d0941p-52; 0x66d298ef8e553p-49; -0xb50d4862bfde3p-50]%float);
(2, [0; 0; 0; 0x1p-60; 1; 1; 1]%float, 3, 1, 0x1a06f9bd6d5a59p-53%float, [-0xe359b2daaad1dp-49; -0x25a488e67d92dp-49; -0x4b4c64e3ce2c5p-47; 0xf39ecb3aa3f3p-47]%float, [-0xe359b2daaad1dp-49; -0x25a488e67d92dp-49; -0xfc0094db2dd71p-49; -0x3570dd8ccc181p-52; 0xf39ecb3aa3f3p-47]%float);
(2, [0; 0; 0; 1; 1; 1]%float, 2, 3, 0xa2a7ae05abb6fp-52%float, [0x98b703bb3ccbp-44; 0x1592abe64ca55p-47; -0x9c4940db7b8e7p-48]%float, [0x98b703bb3ccbp-44; 0x5319106ba073fp-48; -0x5b2f91808a49dp-50; -0x5b2f91808a49dp-50; -0x14e451613c0f3dp-50; -0x9c4940db7b8e7p-48]%float);
(2, [0; 0; 0; 1; 1; 1]%float, 2, 1, 0x66fc2203ac765p-51%float, [0x43b4587444be5p-48; 0x3d50bac5537ebp-47; 0x3006f7471841bp-48]%float, [0x43b4587444be5p-48; 0x1bf95f42fb99p-42; 0x7d36c9e21d22bp-49; 0x3006f7471841bp-48]%float);
(2, [0; 0; 0; 1; 1; 1]%float, 2, 1, 0x1fffffffffffffp-53%float, [-0x1f10a7da45545p-48; -0x2d5b0bc169257p-47; 0x2c54ca3083f8dp-49]%float, [-0x1f10a7da45545p-48; -0x16ad85e0b492b7p-50; 0x58a9946107f19p-50; 0x2c54ca3083f8dp-49]%float);
(2, [0; 0; 0; 0x80fd92bc983c5p-54; 0xaa95dd25b0f23p-54; 0x914c2e9e3a62dp-52; 0x17a3d974f69a63p-53; 0x17a3d974f69a63p-53; 1; 1; 1]%float, 2, 2, 0x380ee4b306c3p-49%float, [-0x9527b019cc5a1p-49; 0xeda04269af1p-48; -0x9730ebd8843afp-48; -0x8676148f75ed1p-48; 0xa288c38bcf971p-49; -0x686a86919d72dp-48; 0xa029e5eb14d7fp-49; 0x5b00148fe8bf7p-48]%float, [-0x9527b019cc5a1p-49; -0x11e5ff98a9ac6dp-53; -0x5743b58397289p-48; -0x630d282c204d9p-48; -0x9730ebd8843afp-48; -0x8676148f75ed1p-48; 0xa288c38bcf971p-49; -0x686a86919d72dp-48; 0xa029e5eb14d7fp-49; 0x5b00148fe8bf7p-48]%float);
(2, [0; 0; 0; 0x80fd92bc983c5p-54; 0xaa95dd25b0f23p-54; 0x914c2e9e3a62dp-52; 0x17a3d974f69a63p-53; 0x17a3d974f69a63p-53; 1; 1; 1]%float, 4, 2, 0x1552bba4b61e47p-55%float, [0x1bffb88880ad1p-47; 0xb7f344a2acca9p-49; 0x1d1f36ad32153p-46; -0x1d35db71758e7fp-50; -0x35fd207a02a63p-47; -0x4bbc43f09dc89p-49; -0xb4f52dcf90ffp-48; -0x41a87021c41d9p-48]%float, [0x1bffb88880ad1p-47; 0xb7f344a2acca9p-49; 0x1d1f36ad32153p-46; 0xbe0cf31502c4dp-49; 0x2f833cc540b13p-47; -0x1d35db71758e7dp-50; -0x35fd207a02a63p-47; -0x4bbc43f09dc89p-49; -0xb4f52dcf90ffp-48; -0x41a87021c41d9p-48]%float);
(2, [0; 0; 0; 0x80fd92bc983c5p-54; 0xaa95dd25b0f23p-54; 0x914c2e9e3a62dp-52; 0x17a3d974f69a63p-53; 0x17a3d974f69a63p-53; 1; 1; 1]%float, 4, 1, 0x7fc63a11316d1p-53%float, [0x24bff78564301p-49; 0x255a64d004a8bp-46; -0xaaee7dba8ea77p-50; 0xc28e99a0058dp-48; -0x25a798796d81p-44; -0x926e473e965p-43; 0x3b476c1987421p-47; -0x7a9ac1882344bp-49]%float, [0x24bff78564301p-49; 0x255a64d004a8bp-46; -0xaaee7dba8ea77p-50; -0x1b5eb5b84dd809p-52; 0x4ef9df37e6f97p-52; -0x25a798796d81p-44; -0x926e473e965p-43; 0x3b476c1987421p-47; -0x7a9ac1882344bp-49]%float);
(2, [0; 0; 0; 0x80fd92bc983c5p-54; 0xaa95dd25b0f23p-54; 0x914c2e9e3a62dp-52; 0x17a3d974f69a63p-53; 0x17a3d974f69a63p-53; 1; 1; 1]%float, 5, 2, 0x914c2e9e3a62dp-52%float, [-0x53034fc6a367p-48; 0xc57962c71bd7p-48; 0x425a3d720dddbp-47; -0x10ee72d2b5c839p-49; 0x19f31b3f217b5p-46; -0x3eaa734aa6d7p-44; 0xbb464b77be89p-46; 0xbd569618f94c7p-49]%float, [-0x53034fc6a367p-48; 0xc57962c71bd7p-48; 0x425a3d720dddbp-47; -0x10ee72d2b5c839p-49; 0x101bfd66f912a5p-51; 0x101bfd66f912a5p-51; 0x19f31b3f217b5p-46; -0x3eaa734aa6d7p-44; 0xbb464b77be89p-46; 0xbd569618f94c7p-49]%float);
(2, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x15c5820c099c61p-53; -0x13bdfdd34d735fp-53; -0x5b0f2dd18ee3bp-52; -0x39d7ba97c4f61p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 3, 1, -0x15c5820c099c61p-53%float, [0x390e38234ac4fp-47; -0xb738ab3687579p-49; -0x5c1b7679cf24dp-49; -0x69c889fb68da9p-49; -0x57df2e82ae235p-49; -0x18be49ca3a81p-49; 0x7635b5dbadf2dp-48]%float, [0x390e38234ac4fp-47; -0xb738ab3687579p-49; -0x192443c892a02bp-51; -0x5c1b7679cf24dp-49; -0x69c889fb68da9p-49; -0x57df2e82ae235p-49; -0x18be49ca3a81p-49; 0x7635b5dbadf2dp-48]%float);
(2, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x15c5820c099c61p-53; -0x13bdfdd34d735fp-53; -0x5b0f2dd18ee3bp-52; -0x39d7ba97c4f61p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 4, 3, -0x9defee9a6b9afp-52%float, [0x86f52444bd4b3p-48; -0x251f4bc0bdeabp-49; 0x1656d828516ddp-47; 0x44be251975ef7p-47; -0x379b8361a3fedp-48; -0x100490248fb8cbp-49; -0xa7c7fc9a7d211p-49]%float, [0x86f52444bd4b3p-48; -0x251f4bc0bdeabp-49; 0x1656d828516ddp-47; 0xfb3a5a23a7199p-50; 0xfb3a5a23a719bp-50; 0xfb3a5a23a719bp-50; 0x112f89465d7bd9p-49; -0x379b8361a3fedp-48; -0x100490248fb8cbp-49; -0xa7c7fc9a7d211p-49]%float);
(2, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x15c5820c099c61p-53; -0x13bdfdd34d735fp-53; -0x5b0f2dd18ee3bp-52; -0x39d7ba97c4f61p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 6, 2, -0x35db3fc090365p-52%float, [0x6eca25e6f397bp-48; -0x192c59e47063adp-50; -0x1cc7cab20c8cdp-46; -0xe95b2cad58a2dp-49; -0x4a095effa8967p-48; 0x206244f2a1edbp-49; -0x4e136feffaac5p-49]%float, [0x6eca25e6f397bp-48; -0x192c59e47063adp-50; -0x1cc7cab20c8cdp-46; -0xe95b2cad58a2dp-49; -0x4a095effa8967p-48; -0x454741a826afbp-48; -0x1131807f7bc0e1p-50; 0x3f752d7ab36d9p-50; -0x4e136feffaac5p-49]%float);
(2, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x15c5820c099c61p-53; -0x13bdfdd34d735fp-53; -0x5b0f2dd18ee3bp-52; -0x39d7ba97c4f61p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 6, 3, 0x1192d7d8440933p-52%float, [-0x8c52d789b6a7bp-49; 0x8cd8224a12f67p-49; 0x1e6e63c41ab05p-48; 0x19dfd993996ddp-48; 0x948dcc1be70ebp-49; -0x72e37304985f9p-49; -0x10179038fad81p-47]%float, [-0x8c52d789b6a7bp-49; 0x8cd8224a12f67p-49; 0x1e6e63c41ab05p-48; 0x19dfd993996ddp-48; 0x948dcc1be70ebp-49; 0x2631294a5bf4fp-51; -0xa16e92c8804d5p-51; -0xa16e92c8804d5p-51; -0xb2d2277531abdp-50; -0x10179038fad81p-47]%float);
(2, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x15c5820c099c61p-53; -0x13bdfdd34d735fp-53; -0x5b0f2dd18ee3bp-52; -0x39d7ba97c4f61p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 6, 2, 0x13333333333333p-51%float, [0x45b0fbd8a4941p-47; 0xa2430ffd8fdcbp-49; 0x994d5904a7933p-48; -0x10abe8e6ae3c2fp-50; 0x273211d17acfdp-48; 0x1b4e26217410dp-47; -0xa9af232ea0555p-50]%float, [0x45b0fbd8a4941p-47; 0xa2430ffd8fdcbp-49; 0x994d5904a7933p-48; -0x10abe8e6ae3c2fp-50; 0x273211d17acfdp-48; 0xda71310ba0867p-50; -0x2a6bc8cba8155p-48; -0x1535e465d40aa9p-51; -0xa9af232ea0555p-50]%float);
(2, [0; 0; 0; 0x3a773241833a9p-453; 0x7f1a354f2921dp-452; 0x1p-400; 0x1p-400; 0x1p-400]%float, 3, 3, 0xc08d602113efp-450%float, [0xa76624d423f63p-49; -0x1457d397aa20bp-48; 0x1b51bd99a1a31p-49; -0x150ef49dbfd195p-50; 0x1aaeb027f24a9p-46]%float, [0xa76624d423f63p-49; -0x1457d397aa20bp-48; -0x7770e99976d57p-52; -0x9ebffeb703e03p-53; -0x9ebffeb703e03p-53; 0x15fe6288711ba5p-54; -0x150ef49dbfd195p-50; 0x1aaeb027f24a9p-46]%float);
(2, [0; 0; 0; 0x3a773241833a9p-453; 0x7f1a354f2921dp-452; 0x1p-400; 0x1p-400; 0x1p-400]%float, 3, 1, 0xd782a732f4fd7p-453%float, [-0x113a4cc74f9f57p-50; 0x583223180e569p-49; -0xdfa1342336dbp-45; -0x1d62485bf5191p-47; 0x44303b59f8123p-47]%float, [-0x113a4cc74f9f57p-50; 0x583223180e569p-49; -0xb02a17c60d521p-49; -0x175c90acc54c31p-50; -0x1d62485bf5191p-47; 0x44303b59f8123p-47]%float);
(2, [0; 0; 0; 0x3a773241833a9p-453; 0x7f1a354f2921dp-452; 0x1p-400; 0x1p-400; 0x1p-400]%float, 4, 1, 0x7f1a354f2921dp-452%float, [0x16b5daec0b1ffp-46; -0x35f95255f5f6fp-48; -0x1cb0cb67cbc843p-50; -0xb2ac3137f8c83p-50; -0x8379879a4adbp-44]%float, [0x16b5daec0b1ffp-46; -0x35f95255f5f6fp-48; -0x1cb0cb67cbc843p-50; -0xa9057b5d63769p-49; -0xb2ac3137f8c83p-50; -0x8379879a4adbp-44]%float);
(2, [0; 0; 0; 0x3a773241833a9p-453; 0x7f1a354f2921dp-452; 0x1p-400; 0x1p-400; 0x1p-400]%float, 4, 1, 0x1fc68d53ca4875p-454%float, [0x212c8874cd40bp-47; 0x91f18270d92f7p-49; -0x12203b5e51556bp-49; 0x8cd4ac96e95c1p-48; 0x5eb41dad6ce21p-49]%float, [0x212c8874cd40bp-47; 0x91f18270d92f7p-49; -0x12203b5e51556bp-49; -0xad25f5c75472fp-51; 0x8cd4ac96e95c1p-48; 0x5eb41dad6ce21p-49]%float);
(2, [0; 0; 0; 0x3a773241833a9p-453; 0x7f1a354f2921dp-452; 0x1p-400; 0x1p-400; 0x1p-400]%float, 4, 3, 0x1fffffffffffffp-453%float, [0xe7deb9cb85fdp-45; -0x67356535f791p-44; -0x117a400ed9e28dp-49; -0x90610f86c86bp-47; -0x91f9ef656063fp-49]%float, [0xe7deb9cb85fdp-45; -0x67356535f791p-44; -0x117a400ed9e28dp-49; -0x483087c364359p-50; -0x48fcf7b2b031fp-48; -0x48fcf7b2b031fp-48; -0x123f3decac0c7dp-50; -0x91f9ef656063fp-49]%float);
(2, [-0x17e3abbc6695fbp-53; -0x8a297c9f5a429p-53; -0x5f47af94f207p-52; 0xb7407d2d12983p-51; 0x7dcbcaecd85e5p-50; 0x7e6f77a82aa2bp-50]%float, 2, 2, -0x5f47af94f207p-52%float, [0x70a408b1ab1dp-46; 0x62c7fb54b263p-47; 0x26cb70b0f5049p-46]%float, [0x70a408b1ab1dp-46; 0x33bcb8bcb62e5p-49; 0x33bcb8bcb62e5p-49; 0x62c7fb54b263p-47; 0x26cb70b0f5049p-46]%float);
(2, [-0x17e3abbc6695fbp-53; -0x8a297c9f5a429p-53; -0x5f47af94f207p-52; 0xb7407d2d12983p-51; 0x7dcbcaecd85e5p-50; 0x7e6f77a82aa2bp-50]%float, 2, 2, 0x184c489b695485p-55%float, [-0x69ca82978745dp-48; -0x48f668f604c6bp-49; -0x1e4e768c4eb29p-49]%float, [-0x69ca82978745dp-48; -0x571100ead075p-44; -0x9ea558bda304fp-49; -0x11191a260118adp-51; -0x1e4e768c4eb29p-49]%float);
(2, [-0x17e3abbc6695fbp-53; -0x8a297c9f5a429p-53; -0x5f47af94f207p-52; 0xb7407d2d12983p-51; 0x7dcbcaecd85e5p-50; 0x7e6f77a82aa2bp-50]%float, 2, 3, 0x105c817b2c1aa5p-52%float, [0x9e7b81b7a7509p-48; -0x3b7c7f4da185dp-47; 0x8bf6883cda303p-48]%float, [0x9e7b81b7a7509p-48; -0x1a22403b280c1fp-51; -0x2567e47a63cbdp-52; -0x2567e47a63cbdp-52; 0x44c430d0c57adp-50; 0x8bf6883cda303p-48]%float);
(3, [0; 0; 0; 0; 0x1p-28; 1; 1; 1; 1]%float, 4, 1, 0xda73d6a2dc667p-53%float, [-0x120263c4b57953p-49; 0x1fe5cadebf9b9p-46; -0xa56c4b1ad4901p-49; -0xbdcef94d7173p-49; 0x259c51126e0a3p-49]%float, [-0x120263c4b57953p-49; 0x1fe5cadebf9b9p-46; 0x9772adce0262bp-50; -0x31f3c187faa9fp-48; 0x93ee26a0bc281p-53; 0x259c51126e0a3p-49]%float);
(3, [0; 0; 0; 0; 0x1p-28; 1; 1; 1; 1]%float, 4, 2, 0xd50e00870f273p-52%float, [-0x1210f4c40080c5p-49; 0x762883e5f18bp-47; -0x9e01feef1e39p-44; 0x3247415e752bbp-47; -0x19fc73225cf33p-47]%float, [-0x1210f4c40080c5p-49; 0x762883e5f18bp-47; -0x81060295ff4c7p-48; 0x19f1c3d925cf7bp-52; -0x18bb775fc71fbdp-53; -0xd313fac08381bp-51; -0x19fc73225cf33p-47]%float);
(3, [0; 0; 0; 0; 0x1p-28; 1; 1; 1; 1]%float, 4, 1, 0x1fffffffffffffp-53%float, [-0x399afc0491cf7p-47; -0x50ddbcfe11ebp-49; -0xebabdd54ca0e9p-49; -0x3d5b521f10e55p-47; -0xfabab41ab0c01p-49]%float, [-0x399afc0491cf7p-47; -0x50ddbcfe11ebp-49; -0x1d757baa9941d1p-50; -0x3d5b521f10e55p-47; -0xfabab41ab0c01p-49; -0xfabab41ab0c01p-49]%float);
(3, [0; 0; 0; 0; 0x1e6d528ce48d6fp-54; 0x1e6d528ce48d7p-50; 0x1e6d528ce48d71p-54; 0xf36a9467246b9p-53; 1; 1; 1; 1]%float, 3, 1, 0x1e19152f3266bp-53%float, [-0xad5fc48e589c5p-49; 0x207e86d2c0957p-47; 0xfecaa8b78675p-46; 0x195115461463dp-47; -0x258d00b9fafe7p-46; 0x42352ab8484dp-46; -0x17d6c39be068c3p-50; -0x61cf5b905750bp-48]%float, [-0xad5fc48e589c5p-49; -0x87dd83d58b661p-49; 0x81a8671a5e565p-49; 0xf8547ea8607b1p-50; 0x195115461463dp-47; -0x258d00b9fafe7p-46; 0x42352ab8484dp-46; -0x17d6c39be068c3p-50; -0x61cf5b905750bp-48]%float);
(3, [0; 0; 0; 0; 0x1e6d528ce48d6fp-54; 0x1e6d528ce48d7p-50; 0x1e6d528ce48d71p-54; 0xf36a9467246b9p-53; 1; 1; 1; 1]%float, 3, 3, 0x4c7170840599p-48%float, [0x5cdbcbbb0c40dp-49; 0xa08db4e3c31fp-46; 0x9b01d66500387p-49; 0x81b12199bed97p-49; -0x3f9d5f934d71p-47; -0x90b4eaa28a107p-48; 0xae38f454e67d7p-49; 0x6762dcc0fb33fp-48]%float, [0x5cdbcbbb0c40dp-49; 0xa9e9899dd4525p-50; 0x1bdfd8773cec85p-51; 0x1f83df3a23e15p-47; 0x86af0c82371afp-49; 0x8b1b667f46dp-41; 0x81b12199bed97p-49; -0x3f9d5f934d71p-47; -0x90b4eaa28a107p-48; 0xae38f454e67d7p-49; 0x6762dcc0fb33fp-48]%float);
(3, [0; 0; 0; 0; 0x1e6d528ce48d6fp-54; 0x1e6d528ce48d7p-50; 0x1e6d528ce48d71p-54; 0xf36a9467246b9p-53; 1; 1; 1; 1]%float, 7, 3, 0xf36a9467246b9p-53%float, [-0x49e4959238259p-47; -0x185448140750b7p-50; -0xfaa8f7e4c43d9p-49; 0x2b77e353c13bp-44; 0xe2b890cadc9fp-48; -0xc8a7b032f83a7p-49; 0x123ba0da761efp-45; 0x4c79e7e1bc39dp-47]%float, [-0x49e4959238259p-47; -0x185448140750b7p-50; -0xfaa8f7e4c43d9p-49; 0x2b77e353c13bp-44; 0xe2b890cadc9fp-48; 0xe2b890cadc9e9p-52; 0xe2b890cadc9e5p-52; 0xe2b890cadc9e5p-52; -0x1914f6065f074bp-50; 0x123ba0da761efp-45; 0x4c79e7e1bc39dp-47]%float);
(3, [0; 0; 0; 0; 0x1e6d528ce48d6fp-54; 0x1e6d528ce48d7p-50; 0x1e6d528ce48d71p-54; 0xf36a9467246b9p-53; 1; 1; 1; 1]%float, 7, 1, 0x1fffffffffffffp-53%float, [-0x10a80a745ef989p-50; -0xba5369a36556fp-49; 0x67b7a704f9149p-48; 0x404ca1b0ccd6bp-48; -0x8e804bac041a3p-49; 0x203257152f135p-46; 0x2c1df43566fedp-49; -0x6fc2cf90500fp-46]%float, [-0x10a80a745ef989p-50; -0xba5369a36556fp-49; 0x67b7a704f9149p-48; 0x404ca1b0ccd6bp-48; -0x8e804bac041a3p-49; 0x80c95c54bc4d3p-48; 0x160efa1ab37f6dp-52; -0x1bf0b3e41403bdp-52; -0x6fc2cf90500fp-46]%float);
(3, [0; 0; 0; 0; 0x199d19e9c07687p-53; 0x199d19e9c07687p-53; 1; 1; 1; 1]%float, 3, 3, 0x9883b3af9b1bfp-53%float, [-0x2026c16fdfadbp-46; 0xb8ee4e45a2da1p-49; -0x96b45d18156ffp-48; 0x274d27f3217e1p-46; -0x8d426f3b3e185p-48; 0x5566ee51e369p-47]%float, [-0x2026c16fdfadbp-46; -0x172ab93884b58bp-51; -0x38b720126f159p-49; -0xcc1b2aded457p-47; -0x14b6eb4dc1b0f5p-52; -0xebeff75fcbec3p-50; 0x274d27f3217e1p-46; -0x8d426f3b3e185p-48; 0x5566ee51e369p-47]%float);
(3, [0; 0; 0; 0; 0x199d19e9c07687p-53; 0x199d19e9c07687p-53; 1; 1; 1; 1]%float, 5, 2, 0x333a33d380ed1p-50%float, [0x339f5274cfb7bp-47; -0x88f60e2f39d61p-48; -0x12ca645d52181p-49; 0x43bd3998baf13p-48; -0x8b1e8dc19dc3fp-49; 0x2f824bda8c603p-49]%float, [0x339f5274cfb7bp-47; -0x88f60e2f39d61p-48; -0x12ca645d52181p-49; 0x1a2c30ae1f0a93p-51; 0x68b0c2b87c2a5p-49; 0x43bd3998baf1p-44; -0x8b1e8dc19dc3dp-49; 0x2f824bda8c603p-49]%float);
(3, [0; 0; 0; 0; 0x199d19e9c07687p-53; 0x199d19e9c07687p-53; 1; 1; 1; 1]%float, 5, 4, 0x1d598223c1d4d3p-53%float, [-0xd82477ff7349bp-49; 0x2b63cbbb83979p-47; 0x8d7fdea5302afp-49; 0x2a9cc1a787145p-48; -0x10e4d1eb6cd85p-48; -0x8d5339ac642ebp-49]%float, [-0xd82477ff7349bp-49; 0x2b63cbbb83979p-47; 0x8d7fdea5302afp-49; 0x1678acd5193a75p-51; 0x1737212f84f467p-52; -0x5046490dbd31dp-52; -0x5046490dbd31dp-52; -0x190bb8ab11fc77p-52; -0xc1649a7e76cbbp-50; -0x8d5339ac642ebp-49]%float);
(3, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; 0x7acbf6cc2d8fp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 3, 3, -0x5333333333333p-50%float, [0x94972e6f4c8fbp-49; 0x19f581fa5c751p-46; -0x1e72b0004ba8f7p-50; -0xe260ae853df3p-48; -0x4331097a04d8dp-49]%float, [0x94972e6f4c8fbp-49; 0x94972e6f4c8fbp-49; 0x94972e6f4c8fbp-49; 0x94972e6f4c8fbp-49; 0xcfac0fd2e3a87p-49; -0x1e72b0004ba8f7p-50; -0xe260ae853df3p-48; -0x4331097a04d8dp-49]%float);
(3, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; 0x7acbf6cc2d8fp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 4, 3, 0x7acbf6cc2d8fp-49%float, [-0x2d94fcc33015p-43; -0x1612e253734cdp-46; 0x14dda8d9fd979p-49; 0x32c96d11b8f81p-47; -0x106141b7fc4765p-49]%float, [-0x2d94fcc33015p-43; -0x1612e253734cdp-46; -0x2f350bd3cb9f3p-48; -0x1dbbdfff9b2dfp-50; -0x1dbbdfff9b2dfp-50; 0x182e7c331dbeadp-51; 0x32c96d11b8f81p-47; -0x106141b7fc4765p-49]%float);
(3, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; 0x7acbf6cc2d8fp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 4, 3, 0xc64fbaf4d7173p-52%float, [-0x13db500bbb1af3p-49; -0x482a3e076f82fp-49; -0x1634bbf7f05bdp-48; -0x55f2635369ac7p-48; -0x48b64ae3f5fc1p-48]%float, [-0x13db500bbb1af3p-49; -0x482a3e076f82fp-49; -0x1c4d3c7d34f473p-52; -0x2cec91e995da5p-48; -0xc6a7a18edd79fp-50; -0x8022a79c2e03p-45; -0x14aae3af94af8bp-50; -0x48b64ae3f5fc1p-48]%float);
(3, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; 0x7acbf6cc2d8fp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 4, 3, 0x1d8d1a05e16dd7p-52%float, [0xcc091fb5d08fp-49; 0x1698a730ed7a5p-46; 0x19e1ce6acfc51p-48; 0x83160e54d0cf5p-49; 0x2586a22e0d153p-47]%float, [0xcc091fb5d08fp-49; 0x1698a730ed7a5p-46; 0x11c303e9d5c06fp-51; 0xe00e24cba4fe7p-50; 0x41e3ca958e68fp-48; 0x8a93aaeb3238fp-49; 0x489e0bb9f03ddp-48; 0x2586a22e0d153p-47]%float);
(3, [0; 0; 0; 0; 0x57d116b4fc877p-453; 0x123fbd09d7e9b7p-453; 0x1a38a3f0dedp-441; 0x3d94b40734dd7p-450; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 3, 3, 0x1329281830a43p-453%float, [-0xe64b842d49e8dp-49; -0x794241a715177p-49; 0x66bc8cb576f05p-49; -0x891e7861e585p-48; 0x471ac9a3203b5p-47; -0xb95f8725cc51p-46; -0x665b55d917ed9p-49; 0x439cea09f24b1p-47]%float, [-0xe64b842d49e8dp-49; -0xce811cc429d6dp-49; -0x171650deda4831p-50; -0x14975d06c880a5p-50; -0xba5e5e6e7eeb1p-50; 0xc285f8419f9d7p-50; -0x891e7861e585p-48; 0x471ac9a3203b5p-47; -0xb95f8725cc51p-46; -0x665b55d917ed9p-49; 0x439cea09f24b1p-47]%float);
(3, [0; 0; 0; 0; 0x57d116b4fc877p-453; 0x123fbd09d7e9b7p-453; 0x1a38a3f0dedp-441; 0x3d94b40734dd7p-450; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 4, 1, 0x669bce56341d9p-453%float, [-0xfb7dfc3f460d7p-49; 0x2d79105ef6511p-47; -0x2bb53d08330c7p-48; 0x8f31cd7d9f017p-48; 0x2b7a726b05893p-48; 0x61919bbb2079bp-48; 0x7eb454ab5213p-44; 0x5f9405004545p-49]%float, [-0xfb7dfc3f460d7p-49; 0x2d79105ef6511p-47; 0x5740775ed01b1p-49; 0x803a1a1005c7p-50; 0x1171a255b8f861p-49; 0x2b7a726b05893p-48; 0x61919bbb2079bp-48; 0x7eb454ab5213p-44; 0x5f9405004545p-49]%float);
(3, [0; 0; 0; 0; 0x57d116b4fc877p-453; 0x123fbd09d7e9b7p-453; 0x1a38a3f0dedp-441; 0x3d94b40734dd7p-450; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 6, 4, 0x1eca5a039a6eb7p-453%float, [-0x48e8fa453131p-43; -0x151a06267d183p-48; 0x5543a800a84edp-49; -0xc0b9803467e9p-46; 0x97fd3dc7f7a5dp-48; 0xb0abf249d0a1p-48; -0x11f8df5cb0708fp-49; 0xcfb2b18c46cbp-46]%float, [-0x48e8fa453131p-43; -0x151a06267d183p-48; 0x5543a800a84edp-49; -0xc0b9803467e9p-46; 0x12ffa7b8fef4b9p-49; 0xbb8502694a279p-51; -0x5327675b81c1bp-48; -0x5327675b81c1bp-48; -0xa64eceb703839p-49; -0x1bd7c973191099p-50; -0x11f8df5cb0708fp-49; 0xcfb2b18c46cbp-46]%float);
(3, [0; 0; 0; 0; 0x57d116b4fc877p-453; 0x123fbd09d7e9b7p-453; 0x1a38a3f0dedp-441; 0x3d94b40734dd7p-450; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 7, 3, 0x1eca5a039a6eb9p-453%float, [-0x16d7f97f393b1p-48; -0x299efc1c30381p-47; -0xcb9aad42fe0afp-49; 0x24635af1cca41p-48; -0x135d328208dd81p-49; 0x299543575453fp-47; 0x8c75a4322ba3p-45; -0x17827bfa896a1p-47]%float, [-0x16d7f97f393b1p-48; -0x299efc1c30381p-47; -0xcb9aad42fe0afp-49; 0x24635af1cca41p-48; -0x135d328208dd81p-49; 0xf8e5b218d1975p-50; 0x11ac7c8ddde88bp-50; 0x46b1f23777a23p-48; 0x91e000f483281p-49; 0x231d690c8ae89p-47; -0x17827bfa896a1p-47]%float);
(3, [-0x19c9c7b207d535p-53; -0x196a6651b4db2bp-53; -0x122545c9a26599p-53; -0x29b55aa1a7aabp-51; 0x8d5dc5df01dbfp-51; 0x52f2dacc08697p-50; 0xbff971a04673bp-51; 0x6a9f0c531ed81p-50]%float, 3, 2, -0x4ccac696999c5p-52%float, [-0x6e776566eca45p-48; -0xed0ab2cb372c7p-49; 0x9688bdbdd304fp-49; -0x478d771886b1fp-47]%float, [-0x6e776566eca45p-48; -0x1c240b2067b87bp-50; -0x1b44e1fc0c5351p-50; -0x160914827aef0dp-50; 0x2415fb1e08c6fp-47; -0x478d771886b1fp-47]%float);
(3, [-0x19c9c7b207d535p-53; -0x196a6651b4db2bp-53; -0x122545c9a26599p-53; -0x29b55aa1a7aabp-51; 0x8d5dc5df01dbfp-51; 0x52f2dacc08697p-50; 0xbff971a04673bp-51; 0x6a9f0c531ed81p-50]%float, 3, 4, -0x13bfcd4068ff1p-53%float, [0xa7fe08171a8dp-49; -0x2668f2b4517d5p-49; -0x1402a06807bedp-48; 0x24146d8a36985p-46]%float, [0xa7fe08171a8dp-49; -0x23dd96ea24c3fp-51; -0x24d71bb833b0bp-50; -0x2974cfdcb17b7p-50; -0x2974cfdcb17b7p-50; -0x1de9444b24e183p-53; 0xbb20e3933cbdp-49; 0x24146d8a36985p-46]%float);
(3, [-0x19c9c7b207d535p-53; -0x196a6651b4db2bp-53; -0x122545c9a26599p-53; -0x29b55aa1a7aabp-51; 0x8d5dc5df01dbfp-51; 0x52f2dacc08697p-50; 0xbff971a04673bp-51; 0x6a9f0c531ed81p-50]%float, 3, 3, 0x11abb8bbe03b7dp-52%float, [-0x1b0232650b4375p-50; 0xf1f8933d0cffp-47; -0xee2f4f6bc8843p-49; -0x5f6395645975fp-49]%float, [-0x1b0232650b4375p-50; 0xf1f8933d0cfedp-51; -0x33dd8ae9f1f01p-47; -0x10fce0e69c4193p-50; -0x10fce0e69c4193p-50; -0x3f282e9c7a02fp-48; -0x5f6395645975fp-49]%float);
(3, [-0x19c9c7b207d535p-53; -0x196a6651b4db2bp-53; -0x122545c9a26599p-53; -0x29b55aa1a7aabp-51; 0x8d5dc5df01dbfp-51; 0x52f2dacc08697p-50; 0xbff971a04673bp-51; 0x6a9f0c531ed81p-50]%float, 4, 2, 0x8d5dc5df01dbfp-51%float, [0x41a81fdf7c8efp-48; 0x98c9412609ad1p-48; 0x2c1bab687ccf1p-48; 0x594fd284d537p-46]%float, [0x41a81fdf7c8efp-48; 0x98c9412609ad1p-48; 0x1ba4c1911ef969p-51; 0x798724c4535e3p-50; 0x1b0b794802d18dp-52; 0x594fd284d537p-46]%float);
(4, [0; 0; 0; 0; 0; 0x1p-51; 0x1p-36; 1; 1; 1; 1; 1]%float, 5, 3, 0x1p-51%float, [0x43e15ea247ff9p-48; -0x565fbc363e5a5p-49; 0x378790945f871p-47; -0x61fc791da0cfp-47; 0x1a24b510ecc5p-43; 0x47cd30e79d79p-46; 0x1633d90cc313fp-49]%float, [0x43e15ea247ff9p-48; -0x565fbc363e5a5p-49; -0xacbaa6748295bp-50; -0xacb5d4862c66bp-50; -0x56588150bd0a3p-49; 0xde1e42517e1c1p-49; -0x187f1e476833bp-49; 0x1a24b510ecc5p-43; 0x47cd30e79d79p-46; 0x1633d90cc313fp-49]%float);
(4, [0; 0; 0; 0; 0; 0x1p-51; 0x1p-36; 1; 1; 1; 1; 1]%float, 5, 1, 0x1fffffffffffffp-89%float, [0x90b498156f9d1p-48; 0x28c4b3073b9ddp-47; -0xcd42759ce261p-47; 0x1b875eb61c4bp-48; 0x1fd3e40274f6fp-46; 0x13c2f1a5b3b05p-46; 0x61f6f5f4cf27bp-49]%float, [0x90b498156f9d1p-48; 0x28c4b3073b9ddp-47; -0x66a13ace71307p-50; -0x66a13ace6a585p-50; 0xdc3af5b4cf10dp-55; 0x1fd3e4027435e3p-50; 0x13c2f1a5b3b05p-46; 0x61f6f5f4cf27bp-49]%float);
(4, [0; 0; 0; 0; 0; 0x1p-51; 0x1p-36; 1; 1; 1; 1; 1]%float, 6, 3, 0x6d123dd10eeabp-53%float, [-0x2b19e23028f95p-49; -0x18aa296e0fd6bp-49; 0xd9f67c45e9ffp-49; -0x1064d2e52f1b7fp-49; 0x26b46feb59751p-47; 0x6a918f1f9f5c3p-48; -0xf2f639f592abp-48]%float, [-0x2b19e23028f95p-49; -0x18aa296e0fd6bp-49; 0xd9f67c45e9ffp-49; -0x169425689c65cbp-52; -0x121f1910a164ebp-51; -0x13a2086a6d1597p-51; -0xb016f4aee190fp-51; 0x14bf00f8c005ddp-50; 0x2850d27b207f7p-47; -0xf2f639f592abp-48]%float);
(4, [0; 0; 0; 0; 0; 0x1p-51; 0x1p-36; 1; 1; 1; 1; 1]%float, 6, 2, 0x56548b318ae01p-51%float, [0x843f6217edba3p-48; 0x123f0575f3b2bp-48; -0x1ac11a2687ebf7p-50; -0xaa9b6bead59cfp-49; 0x7ed3e851f83dfp-48; -0xd0b4a31f51e25p-49; -0x1f436998179f7p-49]%float, [0x843f6217edba3p-48; 0x123f0575f3b2bp-48; -0x1ac11a2687ebf7p-50; -0xb8bea222d927p-45; 0x8e43e91543b7fp-52; -0x343069a577abp-50; -0x9df9ef4b9c35dp-50; -0xb20eba6a2e8bbp-50; -0x1f436998179f7p-49]%float);
(4, [0; 0; 0; 0; 0; 0x2dd47ad230c5p-46; 0x16ea3d69186281p-53; 0x16ea3d69186281p-53; 1; 1; 1; 1; 1]%float, 4, 5, 0xad6cd4220d67p-51%float, [0x9696868832f65p-48; 0xf01055b692cbp-45; 0x2c71140443107p-48; 0x1807a31824907p-48; -0x1629f4a097524bp-50; 0x23ed012d1a87p-44; -0x1ab99042a90447p-50; -0x7df3c9c185b6dp-49]%float, [0x9696868832f65p-48; 0x92f9821b171f5p-48; 0x475da34d4eb0bp-47; 0x1140c80757f929p-49; 0x213e83d224c7dp-46; 0x213e83d224c7dp-46; 0x17d5ba081bc9afp-50; 0x1362b747b3c905p-51; 0xe7cd3dc3a5f9bp-52; -0x1629f4a097524bp-50; 0x23ed012d1a87p-44; -0x1ab99042a90447p-50; -0x7df3c9c185b6dp-49]%float);
(4, [0; 0; 0; 0; 0; 0x2dd47ad230c5p-46; 0x16ea3d69186281p-53; 0x16ea3d69186281p-53; 1; 1; 1; 1; 1]%float, 4, 2, 0x16ea3d6918627fp-53%float, [0x3ec18c8a189ebp-49; -0x91ba3dac507p-45; 0x540e656b2cefp-44; -0x1090832e7b4593p-49; -0xb7510f322548dp-49; -0xaa457a195247bp-50; -0x162153c317699p-47; -0xa420e5a304107p-50]%float, [0x3ec18c8a189ebp-49; -0x91ba3dac506fdp-53; 0x1503995acb3bbdp-50; -0x1090832e7b458dp-49; -0x19d0844a88e275p-50; -0x6742112a2389dp-48; -0xb7510f322548dp-49; -0xaa457a195247bp-50; -0x162153c317699p-47; -0xa420e5a304107p-50]%float);
(4, [0; 0; 0; 0; 0; 0x2dd47ad230c5p-46; 0x16ea3d69186281p-53; 0x16ea3d69186281p-53; 1; 1; 1; 1; 1]%float, 7, 1, 0x5cdc0b10a57afp-51%float, [0xc84b93074655p-48; 0x5f3fe979bf48bp-49; 0x4fbd3781ff387p-49; -0x2e7a1ce847d8bp-47; -0xa19f1d679657p-48; -0x82a50f15f2863p-50; -0x95e57e310132fp-49; -0x17b7aab2e44d33p-50]%float, [0xc84b93074655p-48; 0x5f3fe979bf48bp-49; 0x4fbd3781ff387p-49; -0x2e7a1ce847d8bp-47; -0x41b1cf7f227e1p-49; -0xad894fcd6fe41p-52; -0x11074d2290f9bbp-51; -0x12e6c5bb0ed381p-50; -0x17b7aab2e44d33p-50]%float);
(4, [0; 0; 0; 0; 0; 0x1ddae00ba91ffp-51; 0x1ddae00ba91ffp-51; 1; 1; 1; 1; 1]%float, 4, 1, 0x1ddae00ba91fefp-55%float, [-0x26423d7321c67p-48; -0x21e8e4c06aaf1p-46; -0x17d4ddd1ee9f9p-49; -0xe48c1e2f9ad7p-45; 0x798a1eab2883bp-48; 0x56810882282abp-48; 0x106a3590cd093p-45]%float, [-0x26423d7321c67p-48; -0x10f47260355787p-49; -0x2fa9bba3dd3f3p-50; -0x8f28e1a83c1bdp-50; -0xed16a5a7986e9p-50; 0x798a1eab2883bp-48; 0x56810882282abp-48; 0x106a3590cd093p-45]%float);
(4, [0; 0; 0; 0; 0; 0x1ddae00ba91ffp-51; 0x1ddae00ba91ffp-51; 1; 1; 1; 1; 1]%float, 6, 3, 0x1ddae00ba91ffp-51%float, [-0x4a9559f216acfp-48; 0x766bcb5b59a13p-48; 0x3051a92bf431p-46; 0x83ca07484fe3p-44; 0x7eecce851027fp-48; 0x84c77f0fe9117p-49; -0x84e47c9914d5p-45]%float, [-0x4a9559f216acfp-48; 0x766bcb5b59a13p-48; 0x3051a92bf431p-46; 0xa0010ad1ef11dp-50; 0x1e9297bf4c7073p-51; 0x1e9297bf4c7073p-51; 0x1054f2e47a4487p-49; 0x7eecce851027fp-48; 0x84c77f0fe9117p-49; -0x84e47c9914d5p-45]%float);
(4, [0; 0; 0; 0; 0; 0x1ddae00ba91ffp-51; 0x1ddae00ba91ffp-51; 1; 1; 1; 1; 1]%float, 6, 3, 0x82b588178f14dp-53%float, [0x3e73aa6334b05p-47; -0x1754018338d755p-50; -0x6a3d896e3335p-46; -0xef94557117d6dp-49; 0x3795c5a8a7221p-49; -0x1714e1c5fe309p-49; -0xc13c9fdb6c055p-49]%float, [0x3e73aa6334b05p-47; -0x1754018338d755p-50; -0x6a3d896e3335p-46; -0x64b8ba95cbbdp-45; -0x1d3bc42d418c03p-51; -0x761d29aafbedp-45; -0x12fec6f0a6502fp-50; 0xcbf0b2fe0a481p-51; -0x6fe602a64fa0fp-51; -0xc13c9fdb6c055p-49]%float);
(4, [0; 0; 0; 0; 0; 0x1ddae00ba91ffp-51; 0x1ddae00ba91ffp-51; 1; 1; 1; 1; 1]%float, 6, 2, 0x8181e85aea8e1p-52%float, [-0x1a115f3151657p-49; -0x46023d44ebb45p-47; 0x4d4907fc914dp-43; 0x711bc070beca5p-48; -0x5f671edd31addp-49; -0x7bb9c41fa687dp-49; 0x7f8e3e739a79fp-49]%float, [-0x1a115f3151657p-49; -0x46023d44ebb45p-47; 0x4d4907fc914dp-43; 0x10b30cf4ac5d6bp-49; 0xa4270db4c2b59p-49; 0x1b649f85d0b2bp-52; -0x140c4a7a3324fp-47; -0x112fe52438a9e3p-52; 0x7f8e3e739a79fp-49]%float);
(4, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x1c7afe1bad419p-51; -0xa7b58e8e9a77p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 4, 2, -0x5333333333333p-50%float, [0x712addfca486fp-49; -0xc65ddcafc65p-45; -0x1067e7d9078459p-50; -0x22e75d171845p-42; 0x140ef6a3029c5p-47; 0x49e341d6c80d7p-47; -0x1ecf7f9bee526fp-50]%float, [0x712addfca486fp-49; 0xe255bbf9490ddp-50; 0x38956efe52437p-48; -0xc65ddcafc650bp-53; -0x1067e7d907845bp-50; -0x22e75d171845p-42; 0x140ef6a3029c5p-47; 0x49e341d6c80d7p-47; -0x1ecf7f9bee526fp-50]%float);
(4, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x1c7afe1bad419p-51; -0xa7b58e8e9a77p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 4, 2, -0x1c7afe1bad4191p-55%float, [-0x2f479d2c655e9p-48; 0x6eac46747dcb9p-48; -0xdc4ee0841e51p-45; -0x7f947f91e9b3p-45; 0x1542f59b22a09p-48; 0x3cb86bf2709b7p-47; 0xb71085d29b45p-48]%float, [-0x2f479d2c655e9p-48; 0x6eac46747dcb9p-48; -0x1393db805dc59bp-50; -0x178076034fe13p-46; -0x9fbd1278af725p-49; -0x4e0b1dae7d16fp-49; 0x1542f59b22a09p-48; 0x3cb86bf2709b7p-47; 0xb71085d29b45p-48]%float);
(4, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x1c7afe1bad419p-51; -0xa7b58e8e9a77p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 5, 1, -0x1d0224de90eafp-52%float, [0x16e93cbd0ae21p-48; 0x2ca06162e9517p-47; -0x5677e517cc533p-48; -0x69bb1200e2be3p-49; -0x419114de7fb6bp-47; -0xc87a7f2a9d5a7p-49; -0x2848b28f32dcdp-49]%float, [0x16e93cbd0ae21p-48; 0x2ca06162e9517p-47; -0x13178dfdc3301bp-50; -0x4bb0e514f789p-44; -0x137df35061afb7p-50; -0x103b1bdd07771bp-49; -0xc87a7f2a9d5a7p-49; -0x2848b28f32dcdp-49]%float);
(4, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x1c7afe1bad419p-51; -0xa7b58e8e9a77p-52; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 6, 1, 0x1a2a4deabba93p-51%float, [0x6abf020ed5523p-48; -0x6a22151daa0b9p-49; 0x88294143e5bbp-44; 0x3101f80e68f67p-48; -0x634d81a60e9d9p-49; -0x1937cfacbacf1p-46; 0x247af23d2d05dp-46]%float, [0x6abf020ed5523p-48; -0x6a22151daa0b9p-49; 0x88294143e5bbp-44; 0x192e60a440b533p-50; 0x8e49ce3b89325p-52; -0x1cfeac566e5a1dp-51; -0x1304246a6287cdp-50; 0x247af23d2d05dp-46]%float);
(4, [0; 0; 0; 0; 0; 0x64e0fff25b75p-447; 0x1a831ef4800485p-453; 0x1bb7a6b3f705e1p-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 4, 1, 0x96605d99055abp-452%float, [-0xd4e510d337003p-49; -0xec4edb756a373p-49; 0x9216d3a277c1dp-49; 0x8cdb2866dca31p-48; -0x114d5dccfad75p-47; 0x277258ff0b183p-46; 0x5cbceac809791p-49; 0x151c4f38432f7p-46]%float, [-0xd4e510d337003p-49; -0x1ccb0da72f489fp-50; 0x8b3dbae35879fp-51; 0x1dc20f78cf33e9p-50; 0x12e504391611a7p-51; -0x114d5dccfad75p-47; 0x277258ff0b183p-46; 0x5cbceac809791p-49; 0x151c4f38432f7p-46]%float);
(4, [0; 0; 0; 0; 0; 0x64e0fff25b75p-447; 0x1a831ef4800485p-453; 0x1bb7a6b3f705e1p-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 6, 2, 0x1a831ef4800485p-453%float, [-0x7ca5a5771d72bp-48; -0x9f879a046e3a5p-48; -0x10291e85d48519p-49; -0x4abebe3433de7p-47; -0x2a5012efdaf6bp-49; -0x6256adb033b5dp-48; 0x392044eb9a82bp-47; 0x32f929424627dp-47]%float, [-0x7ca5a5771d72bp-48; -0x9f879a046e3a5p-48; -0x10291e85d48519p-49; -0x252724dd1dc75p-46; -0x17dffb9a19fb59p-51; -0x538c5910e1f8fp-49; -0x11ef3a49139c69p-51; -0x6256adb033b5dp-48; 0x392044eb9a82bp-47; 0x32f929424627dp-47]%float);
(4, [0; 0; 0; 0; 0; 0x64e0fff25b75p-447; 0x1a831ef4800485p-453; 0x1bb7a6b3f705e1p-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 7, 4, 0xed192dac18e69p-452%float, [-0x943d9acbbedb5p-49; -0x9597e5bf36bddp-49; -0x9b9345626f185p-49; -0xaaff68b2cc253p-49; 0xb2d490bbae41p-49; 0x190f1f93181abp-46; -0xf4823c05ebf3dp-50; -0x358c40081fd1p-45]%float, [-0x943d9acbbedb5p-49; -0x9597e5bf36bddp-49; -0x9b9345626f185p-49; -0xaaff68b2cc253p-49; -0x2461d47ba8843p-53; 0x15b60fb7672bf1p-51; 0x978fe43375fb9p-50; 0x3417d7dab8f2dp-49; 0xb789224d0809p-48; -0xfe51caa491369p-52; -0x5b73fb1bdb9a1p-49; -0x358c40081fd1p-45]%float);
(4, [-0xeb12dfa18732fp-52; -0xc6baacade39a3p-52; -0xbbb7ffd452ce7p-52; -0xdbc2861cc84c7p-53; -0x37ed3d6d15aa9p-53; 0xa37ab991b943dp-51; 0x5d4c176f2c903p-50; 0xc83fcb388c781p-51; 0x1c979cb0176cc5p-52; 0x7b344d10ea1e9p-50]%float, 4, 1, -0x1bf69eb68ad547p-56%float, [0x7d7c3280803p-40; -0xd7f2512abdd3bp-49; -0x897dc2abaeb1p-44; 0x64836e023aab9p-48; -0x1caffba8767debp-50]%float, [0x7d7c3280803p-40; 0x18d2eec19e40e3p-51; -0xe8c2cbfb954fbp-49; -0xc6950c417a921p-49; 0x1920db808eaae3p-50; -0x1caffba8767debp-50]%float);
(4, [-0xeb12dfa18732fp-52; -0xc6baacade39a3p-52; -0xbbb7ffd452ce7p-52; -0xdbc2861cc84c7p-53; -0x37ed3d6d15aa9p-53; 0xa37ab991b943dp-51; 0x5d4c176f2c903p-50; 0xc83fcb388c781p-51; 0x1c979cb0176cc5p-52; 0x7b344d10ea1e9p-50]%float, 4, 1, 0x124edc19963ebp-54%float, [0x97a1d92de36c1p-49; 0x396184e770ff1p-48; -0x1664d033045b77p-50; 0xb7a7421c3b053p-49; -0x926022568f657p-48]%float, [0x97a1d92de36c1p-49; 0x895f741c98293p-49; 0x1c0004aea14a7p-50; -0xc393a8e99931fp-50; 0x12f6fece92c503p-50; -0x926022568f657p-48]%float);
(4, [-0xeb12dfa18732fp-52; -0xc6baacade39a3p-52; -0xbbb7ffd452ce7p-52; -0xdbc2861cc84c7p-53; -0x37ed3d6d15aa9p-53; 0xa37ab991b943dp-51; 0x5d4c176f2c903p-50; 0xc83fcb388c781p-51; 0x1c979cb0176cc5p-52; 0x7b344d10ea1e9p-50]%float, 4, 2, 0x338e677c72f19p-54%float, [0x3fa14d33d48cdp-47; 0x3b6795ba4f55p-46; -0xfcb8a0babd2f7p-50; 0x27c776c39d50bp-46; 0x913439cfe1b59p-49]%float, [0x3fa14d33d48cdp-47; 0x5202663ada729p-48; 0x59e9050fc4859p-49; -0xc34a233bf96cbp-52; 0x2d8ef5d84d81dp-51; 0x12fabff66a3f1dp-49; 0x913439cfe1b59p-49]%float);
(4, [-0xeb12dfa18732fp-52; -0xc6baacade39a3p-52; -0xbbb7ffd452ce7p-52; -0xdbc2861cc84c7p-53; -0x37ed3d6d15aa9p-53; 0xa37ab991b943dp-51; 0x5d4c176f2c903p-50; 0xc83fcb388c781p-51; 0x1c979cb0176cc5p-52; 0x7b344d10ea1e9p-50]%float, 5, 2, 0xa37ab991b943dp-51%float, [0x17b1ebc754dc5p-48; 0x19f3db6e49f5bp-46; 0x9b2bbbd6dafp-48; -0x9cc255c3e55e1p-49; -0x11be9dd1f1d143p-50]%float, [0x17b1ebc754dc5p-48; 0x19f3db6e49f5bp-46; 0x123978269988c1p-53; -0x1ddb7d123dd45fp-51; -0x11fc65468acfabp-50; -0x91efc3d0b073bp-49; -0x11be9dd1f1d143p-50]%float);
(5, [0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1]%float, 5, 5, 0x297a21c3b2a71p-52%float, [-0x18f6965c39e5dp-48; 0x9fea372bdd4afp-48; -0x885720adb60a7p-48; 0x4bba9d4b7937fp-47; 0xa861dcdf258dfp-49; -0x11d17af9e7610bp-49]%float, [-0x18f6965c39e5dp-48; 0x4fd9e12d36c1bp-52; 0x594236aa67039p-50; 0x1f89fc7d382df3p-52; 0x11e80e386d3557p-51; 0x12a0a266a5ae99p-51; 0x165b4aa3a395f5p-51; -0x2f2a99fcbe647p-49; 0xfaf304d235069p-49; 0xbdd21b4581397p-50; -0x11d17af9e7610bp-49]%float);
(5, [0; 0; 0; 0; 0; 0; 1; 1; 1; 1; 1; 1]%float, 5, 4, 0xe6dd7e8ab669p-49%float, [0xd009cc70f83p-43; -0x13265e30d91c07p-49; -0x156bfd9fb879bp-47; 0x13092fd5664efp-45; 0x61540d8d4818fp-49; 0xa578e5db18165p-49]%float, [0xd009cc70f83p-43; -0x36ccbc1b412e9p-48; -0x4cbb457ce8bf1p-48; -0x3a9093076786dp-48; -0x1a766e9f21be5p-48; 0x154186769b283p-47; 0x9dcd502c66957p-49; 0xadab0c848f297p-49; 0x800e1577218e9p-49; 0xa578e5db18165p-49]%float);
(5, [0; 0; 0; 0; 0; 0; 0x15161352f9dcd1p-54; 1; 1; 1; 1; 1; 1]%float, 5, 5, 0x4b4521319b501p-52%float, [0x2b0cea7a4bb03p-48; -0x1902ddede2581p-46; -0x13a49993d15949p-49; -0x2d28d75246b0dp-47; -0xd7a78877b5439p-49; 0x4bb21779510fdp-49; -0xa41c6a120237p-47]%float, [0x2b0cea7a4bb03p-48; -0x152985fdea2c4dp-50; -0x1c57b512c6ffc3p-50; -0x1e78770b1c8077p-50; -0x3db10ab94b835p-47; -0x78fa344e0d887p-48; -0x1e2bfcdf760847p-50; -0x71c7a7a176dafp-48; -0x15a07b313fbcb1p-50; -0x103fb3359f3d4bp-50; 0x4bb21779510fdp-49; -0xa41c6a120237p-47]%float);
(5, [0; 0; 0; 0; 0; 0; 0x15161352f9dcd1p-54; 1; 1; 1; 1; 1; 1]%float, 5, 2, 0x15161352f9dcdp-50%float, [-0x8ef71ea7d3fb7p-49; -0xa6a71b71271b1p-49; -0xa4abfaec39f0dp-49; -0x2d6fb78b9f075p-47; 0xd716f785d439p-46; 0xe64197c3e317p-46; -0x19ec7b95c19ef1p-50]%float, [-0x8ef71ea7d3fb7p-49; -0xa6a71b71271b1p-49; -0xa60005d93c72bp-49; -0x14ed4e9fb7b405p-50; -0x47553fe21a1abp-48; -0x56cbd48ebaf55p-51; 0x6e0b17aacbea7p-49; 0xe64197c3e317p-46; -0x19ec7b95c19ef1p-50]%float);
(5, [0; 0; 0; 0; 0; 0; 0x15161352f9dcd1p-54; 1; 1; 1; 1; 1; 1]%float, 6, 5, 0x15161352f9dcd1p-54%float, [0x91cdba94ef145p-48; 0x1a90640800cf5p-48; 0x2e7dd069ac051p-48; -0x8bd573159630fp-49; 0xf4fc14ed5b45p-46; 0x7872c919e459p-44; -0xbc99a8cd4514dp-49]%float, [0x91cdba94ef145p-48; 0x1a90640800cf5p-48; 0x8484ace682f09p-50; 0xc72a23a83eda3p-51; 0xf97ab7a573659p-52; 0x2aa57d3634625p-50; 0x2aa57d3634625p-50; 0x28199b5a6d78dp-54; 0x8b3692c515b8fp-52; 0x14301b4af45749p-50; 0x7872c919e459p-44; -0xbc99a8cd4514dp-49]%float);
(5, [0; 0; 0; 0; 0; 0; 0x15161352f9dcd1p-54; 1; 1; 1; 1; 1; 1]%float, 6, 2, 0xe8c2d21a2fec9p-52%float, [0x2e0f0cfb2c4a1p-47; -0xa0774fc0e20d7p-49; -0xfc7565d3374c7p-49; -0x5318318a4b29p-49; -0x64374be799095p-48; -0x16eb9104217d1p-46; -0x114da0b9f8345bp-50]%float, [0x2e0f0cfb2c4a1p-47; -0xa0774fc0e20d7p-49; -0xf41b95ce10551p-49; -0xbd28d28ea0cf9p-51; -0x1514396812c5f9p-50; -0x1716c1c201c57p-46; -0x12bf53ec445ebp-46; -0x484131cd494f5p-48; -0x114da0b9f8345bp-50]%float);
(5, [0; 0; 0; 0; 0; 0; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 1; 1; 1; 1; 1; 1]%float, 11, 4, 0xc96fa75f71533p-52%float, [0x20bed606ada2fp-46; -0x7bb6972114a29p-48; 0x267d53c011265p-46; -0x196e9f3a4da8adp-50; 0x1ed09fdc141a1p-48; -0x60f1e54a8cd45p-48; 0x453d1a46e9c7dp-49; -0x19e054873194e1p-50; 0x2579451c4e05bp-46; 0x842fe9083ee41p-48; 0x6b922eb8578dfp-49; 0x2072b9dc87255p-46]%float, [0x20bed606ada2fp-46; -0x7bb6972114a29p-48; 0x267d53c011265p-46; -0x196e9f3a4da8adp-50; 0x1ed09fdc141a1p-48; -0x60f1e54a8cd45p-48; 0x453d1a46e9c7dp-49; -0x10e64b96e7e07p-46; 0x164d95dd0ad29p-47; 0x211302b0086cdp-47; 0x14c7b175ac696dp-50; 0x1ccea933b5f0fp-46; 0x75a943ad79575p-48; 0x17fd44c4648b07p-50; 0x28674534f8b49p-47; 0x2072b9dc87255p-46]%float);
(5, [0; 0; 0; 0; 0; 0; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x170da01c41e95dp-55; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 0x55ab41061b111p-51; 1; 1; 1; 1; 1; 1]%float, 11, 1, 0x1d9e8b992ea49fp-53%float, [-0x134bb26dc72405p-49; 0x7dee59bf7364dp-48; -0x4f93692f2c4adp-47; 0x1fb603c1b244dp-46; -0x15d530d1d24edp-46; 0x100fecb550f61p-46; 0x6e39ae45c0099p-49; -0xa62eff888b57p-45; 0x3e223f6b28ecfp-48; 0x5a75c1be58a55p-48; 0x130539d05337bp-45; -0x7ad556394719dp-48]%float, [-0x134bb26dc72405p-49; 0x7dee59bf7364dp-48; -0x4f93692f2c4adp-47; 0x1fb603c1b244dp-46; -0x15d530d1d24edp-46; 0x100fecb550f61p-46; 0x6e39ae45c0099p-49; -0x11a3489cb0e4fdp-50; 0x187a64f9c7e1d9p-51; 0xa82cef7f842b3p-49; 0x8a48599cbb165p-48; -0x1e7c3932e3d75bp-51; -0x7ad556394719dp-48]%float);
(5, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x21ffea554823fp-49; -0x1d753f0456a1fp-52; 0x12e7af9dbf08bp-51; 0xb2d885b76b8dp-50; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 6, 2, -0xe3514f88cae55p-52%float, [-0x3b275c73bc70bp-49; 0x5c0b42ec1728bp-49; 0x74657e93807f1p-48; -0x8e2ca110bc759p-48; 0x19799c2c3933dp-47; 0x23250edabe11p-46; -0xf7f6236a0091p-47; -0xf3cf93fbf1f79p-49; -0x8794dd47bef1fp-49; 0x9ffdb1abf532bp-49]%float, [-0x3b275c73bc70bp-49; 0x5c0b42ec1728bp-49; 0x8cfcb96197563p-49; 0x1e6ea69522b72fp-51; 0x2c1b223a7d3ddp-51; -0x6547dabe8ec8bp-49; 0x1621e8539780b1p-51; 0x1b1fb69779b9c9p-54; -0xf7f6236a0091p-47; -0xf3cf93fbf1f79p-49; -0x8794dd47bef1fp-49; 0x9ffdb1abf532bp-49]%float);
(5, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x21ffea554823fp-49; -0x1d753f0456a1fp-52; 0x12e7af9dbf08bp-51; 0xb2d885b76b8dp-50; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 6, 5, -0x101f01832e1405p-53%float, [0x516fba8b122d9p-48; 0x79a76418a20fdp-48; 0x1a171ecba739dp-46; -0xd68012a98a851p-49; 0x79d9508375159p-49; 0x76204b7cbc13p-44; 0x50a66c39281a5p-48; -0x4786ad329429dp-48; 0x4003627d1e6a5p-48; -0x467dd939977a9p-49]%float, [0x516fba8b122d9p-48; 0x79a76418a20fdp-48; 0x1b822e468c972dp-50; 0xe024e72bfe8c3p-51; -0x10b79a658ac15p-53; 0xe8c534a9eb3ebp-53; 0x150cfc459f6d1bp-52; 0x1ea2bee60b03a3p-52; 0xd5c0e5b4bd7f1p-50; 0x13e01f090d6c9bp-50; 0xe02878344c491p-49; 0x50a66c39281a5p-48; -0x4786ad329429dp-48; 0x4003627d1e6a5p-48; -0x467dd939977a9p-49]%float);
(5, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x21ffea554823fp-49; -0x1d753f0456a1fp-52; 0x12e7af9dbf08bp-51; 0xb2d885b76b8dp-50; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 7, 2, -0x1d753f0456a1fp-52%float, [0x93b6d6228eca9p-49; 0x1c2d2bb1b7a55p-47; -0x747a78f3bd32fp-48; 0x2d0eaab1c0c39p-48; -0x119cb5745f74adp-49; -0x17711507a0013p-46; 0x33f7ceea23933p-47; 0x108449c0908a7p-45; -0x4eab5bb27638dp-48; 0xa9389dc2d8633p-49]%float, [0x93b6d6228eca9p-49; 0x1c2d2bb1b7a55p-47; -0x747a78f3bd32fp-48; 0x7de6822b56a8bp-51; -0x5290574d54337p-48; -0x1e65d59ca690fp-46; -0xcc78a285c34d1p-49; -0x13d5d96f8abe97p-51; 0x33f7ceea23933p-47; 0x108449c0908a7p-45; -0x4eab5bb27638dp-48; 0xa9389dc2d8633p-49]%float);
(5, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x21ffea554823fp-49; -0x1d753f0456a1fp-52; 0x12e7af9dbf08bp-51; 0xb2d885b76b8dp-50; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 8, 1, 0x12e7af9dbf08b1p-55%float, [-0x1486b00241b3p-49; -0x307eafbd091c5p-48; -0x428e6c09e493dp-47; -0x2ac48f4088e51p-49; 0x10a2c60864363p-48; 0x3832f723455e1p-47; -0x3f8d0917a4dbp-43; -0x87ec485c64b37p-49; -0x9eb28046c0b2fp-48; -0x2ea07dd0976cdp-47]%float, [-0x1486b00241b3p-49; -0x307eafbd091c5p-48; -0x428e6c09e493dp-47; -0x2ac48f4088e51p-49; 0x1fe1ae6d9246cbp-53; 0xd86b2f0157f3bp-50; 0x72c25afd43897p-50; -0xf1d89b9ccc825p-49; -0x87ec485c64b37p-49; -0x9eb28046c0b2fp-48; -0x2ea07dd0976cdp-47]%float);
(5, [-0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x14cccccccccccdp-52; -0x21ffea554823fp-49; -0x1d753f0456a1fp-52; 0x12e7af9dbf08bp-51; 0xb2d885b76b8dp-50; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49; 0x4cccccccccccdp-49]%float, 8, 5, 0x165b10b6ed719fp-55%float, [0x666a38e1011cdp-48; 0x8c62419089089p-48; -0xb6635c39325e5p-49; -0xb5105397b009p-49; 0xf313bfbfd313p-49; -0x5e289ebdbf13p-49; 0x24bd54d59a061p-46; 0x900700e0a5fa9p-48; -0x93ac5cd39bf19p-48; -0x3ad4839c60129p-49]%float, [0x666a38e1011cdp-48; 0x8c62419089089p-48; -0xb6635c39325e5p-49; -0xb5105397b009p-49; 0xf313bfbfd313p-49; 0x3655c4d7d15f7p-52; 0xa224bfbc923b5p-51; 0x1909b8766ba929p-52; 0x197d191ae666f1p-52; 0x197d191ae666f1p-52; 0xfac491d9aa353p-50; 0x125187e9743cbfp-49; 0x8c89304b04dabp-48; -0x93ac5cd39bf19p-48; -0x3ad4839c60129p-49]%float);
(5, [0; 0; 0; 0; 0; 0; 0x3c0592ea96dfbp-451; 0x6392decfade31p-451; 0x6f0df86b02d35p-451; 0x1c84c9922bf16fp-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 5, 3, 0x27564c632ffdp-447%float, [0x5250a44a5ed13p-49; -0x114f0ea7275ccbp-49; -0xa020df44bfc3p-45; 0x1b7bfbb49ccdfp-48; 0x123bf590b374dp-45; 0x412333ecddacbp-48; -0x11d3a71e8a95a3p-49; 0x627c57fa04b59p-48; -0xb821909a0c863p-49; 0xf44a110fbc43p-47]%float, [0x5250a44a5ed13p-49; -0x13244d61be01fbp-50; -0x1980fc0fafa295p-50; -0x16f1896eeb51dp-46; -0x1ab45490ceb0b7p-51; 0x730cae133a41dp-50; 0x15a003a4068d9p-46; 0xf21fa1ef27p-37; 0x412333ecddacbp-48; -0x11d3a71e8a95a3p-49; 0x627c57fa04b59p-48; -0xb821909a0c863p-49; 0xf44a110fbc43p-47]%float);
(5, [0; 0; 0; 0; 0; 0; 0x3c0592ea96dfbp-451; 0x6392decfade31p-451; 0x6f0df86b02d35p-451; 0x1c84c9922bf16fp-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 6, 3, 0x1e02c9754b6fd9p-454%float, [-0x8c57f7d776c59p-48; 0x5741e67359e49p-48; -0x121b2400462bp-46; 0x218fc4adfdabbp-48; 0x83102743d8105p-49; 0x1e09ab19f54c7p-48; -0x356f4dda898bp-45; -0x720335e2e321p-45; 0x133df209424fp-45; -0xa28e12c79d37bp-49]%float, [-0x8c57f7d776c59p-48; 0x5741e67359e49p-48; 0x1fee65517c7663p-52; 0x165d189cce4583p-52; 0x3b7dc741d69ddp-49; 0x2ab5ae248c8bdp-48; 0xc66292b7f1121p-50; 0x30e346f4dee83p-48; 0x1e09ab19f54c6fp-52; -0x356f4dda898bp-45; -0x720335e2e321p-45; 0x133df209424fp-45; -0xa28e12c79d37bp-49]%float);
(5, [0; 0; 0; 0; 0; 0; 0x3c0592ea96dfbp-451; 0x6392decfade31p-451; 0x6f0df86b02d35p-451; 0x1c84c9922bf16fp-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 6, 4, 0x8aa67226a6999p-452%float, [-0x327f29d417c69p-48; 0x8d725188fc64fp-49; 0x72e33a262d9e1p-49; -0x16240e45ba1cbp-49; 0x5b5b8530792ebp-48; -0x6c8bec43f6069p-49; -0x13dae41aedd049p-49; 0x37c14a1c06a2bp-47; 0x4fcfc4700c385p-48; 0x9885732f1f5c9p-49]%float, [-0x327f29d417c69p-48; 0x8d725188fc64fp-49; 0xf5e953a0694dp-46; 0x1ce46e0fed6ea3p-52; 0x8b6e54d05d68fp-50; 0x81a551deb8403p-50; 0xeec9b122df9dbp-51; 0x1723e409ac443p-48; 0x2c716bce36613p-53; -0x892b08e40b8c5p-49; -0x13dae41aedd049p-49; 0x37c14a1c06a2bp-47; 0x4fcfc4700c385p-48; 0x9885732f1f5c9p-49]%float);
(5, [0; 0; 0; 0; 0; 0; 0x3c0592ea96dfbp-451; 0x6392decfade31p-451; 0x6f0df86b02d35p-451; 0x1c84c9922bf16fp-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 6, 2, 0x18e4b7b3eb78c3p-453%float, [0x8fbd55b90c937p-48; -0xca646efbf44bp-47; -0x6a0c5c28e69dp-47; 0xa2631c19f401p-47; -0xd349ac8d4e69p-47; 0x80918ba648ed9p-48; -0x279833917509bp-46; -0x12e0e7d8e9befp-45; 0x9db4a8ce7cbb9p-48; 0x22dddbc9d0091p-48]%float, [0x8fbd55b90c937p-48; -0xca646efbf44bp-47; -0x1a83170a39a741p-53; 0x86a2de18f3e9p-47; -0x84ef7d6896f89p-51; 0x9f28d2a5ee691p-49; 0x221296caa3b69p-49; -0x13317439f3f543p-51; -0x279833917509bp-46; -0x12e0e7d8e9befp-45; 0x9db4a8ce7cbb9p-48; 0x22dddbc9d0091p-48]%float);
(5, [0; 0; 0; 0; 0; 0; 0x3c0592ea96dfbp-451; 0x6392decfade31p-451; 0x6f0df86b02d35p-451; 0x1c84c9922bf16fp-453; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400; 0x1p-400]%float, 7, 2, 0x6392decfade31p-451%float, [-0x5aea0d3211fd3p-48; 0x335d2be5d80e1p-47; 0x3dfd7ff1e5631p-47; 0x824479314699p-47; -0x1070d1a8cc5f0bp-50; 0x82b26e2d8f211p-48; -0x24099bdae3b53p-46; -0xc89d3e93ef43dp-50; 0x23d13a5dfbe73p-47; -0x198cabb899ded7p-50]%float, [-0x5aea0d3211fd3p-48; 0x335d2be5d80e1p-47; 0x3dfd7ff1e5631p-47; 0x1b6accfaa0229fp-52; -0x5d8e8966ff7dp-45; 0x89ee3fa737e47p-49; 0x13689ebdfdb7f5p-52; -0x74df38c4e3e93p-50; -0x24099bdae3b53p-46; -0xc89d3e93ef43dp-50; 0x23d13a5dfbe73p-47; -0x198cabb899ded7p-50]%float);
(5, [-0xe91c1c60882d9p-52; -0xe8d5bfeb22badp-52; -0x1527dd303cb017p-53; -0xd9edfad6d173bp-53; -0x3f289a91aac8fp-52; -0x2e15fbf703cb9p-52; 0xb88eaec535255p-53; 0x10a82668a78c3p-48; 0x4bf4bde288ac7p-50; 0x9d1c4d863f667p-51; 0x19439c75c978ddp-52; 0xe5783c5d8ddd3p-51; 0x7ddcbe3a744b5p-50]%float, 5, 6, -0x743db3e9d5aa3p-55%float, [0x1e445cc7cbb49p-49; 0x34ffff62a77fp-43; -0xb303119b0a6dp-46; -0xca2b12e3fca5p-47; 0x9ed474f0233bp-45; 0x43f1335246aa3p-49; -0x10adbb85f49099p-49]%float, [0x1e445cc7cbb49p-49; 0x13097636b9eb97p-50; 0xf8928c7a22403p-50; 0xbaa10bbc72c4bp-50; 0x1312e68e4cb1c1p-51; 0x82a7a2aa213b3p-50; 0x82a7a2aa213b3p-50; 0xe1a0ffb1bf87dp-52; -0x10cbbcf12cec45p-51; -0x2096190c42efbp-51; 0x130ebfd9b6c639p-50; 0x43f1335246aa3p-49; -0x10adbb85f49099p-49]%float);
(5, [-0xe91c1c60882d9p-52; -0xe8d5bfeb22badp-52; -0x1527dd303cb017p-53; -0xd9edfad6d173bp-53; -0x3f289a91aac8fp-52; -0x2e15fbf703cb9p-52; 0xb88eaec535255p-53; 0x10a82668a78c3p-48; 0x4bf4bde288ac7p-50; 0x9d1c4d863f667p-51; 0x19439c75c978ddp-52; 0xe5783c5d8ddd3p-51; 0x7ddcbe3a744b5p-50]%float, 6, 4, 0xb88eaec535255p-53%float, [-0x130e6b8edd197fp-50; -0x979c9f5c52cc5p-48; 0x64207946a17d3p-48; 0x96b38801548b7p-48; 0x3274d3b8f603bp-48; 0xb200deb8f889bp-49; -0x41e2f147c1b11p-49]%float, [-0x130e6b8edd197fp-50; -0x979c9f5c52cc5p-48; -0x438197bca3fdp-51; 0x10a8aa74d95241p-50; 0x5afb6a80543edp-48; 0x62581da9f4085p-48; 0xd73ab74131317p-49; 0xb6a3d7e1708edp-49; 0x7c9993844cee1p-49; 0xb200deb8f889bp-49; -0x41e2f147c1b11p-49]%float);
(5, [-0xe91c1c60882d9p-52; -0xe8d5bfeb22badp-52; -0x1527dd303cb017p-53; -0xd9edfad6d173bp-53; -0x3f289a91aac8fp-52; -0x2e15fbf703cb9p-52; 0xb88eaec535255p-53; 0x10a82668a78c3p-48; 0x4bf4bde288ac7p-50; 0x9d1c4d863f667p-51; 0x19439c75c978ddp-52; 0xe5783c5d8ddd3p-51; 0x7ddcbe3a744b5p-50]%float, 6, 2, 0x1711d5d8a6a4abp-54%float, [0x62bed34c40039p-48; -0x9428706f8b033p-49; -0x9f5b7cc1315f9p-50; -0x24b538abfd7d7p-47; -0x4b437670b7959p-48; 0x3a997fd9c178fp-47; -0x9dcc49580a9b5p-48]%float, [0x62bed34c40039p-48; -0x9428706f8b033p-49; -0xd61e4d81bfa09p-50; -0x6dee5052d1a75p-49; -0x1fe8d9388f63c3p-51; -0xcf89b94e6dc21p-50; -0x4081afc772893p-50; 0x1d4cbfece0bc77p-50; -0x9dcc49580a9b5p-48]%float);
(5, [-0xe91c1c60882d9p-52; -0xe8d5bfeb22badp-52; -0x1527dd303cb017p-53; -0xd9edfad6d173bp-53; -0x3f289a91aac8fp-52; -0x2e15fbf703cb9p-52; 0xb88eaec535255p-53; 0x10a82668a78c3p-48; 0x4bf4bde288ac7p-50; 0x9d1c4d863f667p-51; 0x19439c75c978ddp-52; 0xe5783c5d8ddd3p-51; 0x7ddcbe3a744b5p-50]%float, 6, 1, 0x910843b0202ebp-52%float, [-0xca3e4415eb6d7p-49; 0x16c7c086c6b43p-46; 0x2cd7c04f3d8dp-45; 0x292c5c5192bf9p-47; 0x1f531e2abc02fp-47; 0x3e1d181bc78cdp-47; 0x1bbd885d0deefp-48]%float, [-0xca3e4415eb6d7p-49; 0x16c7c086c6b43p-46; 0x14c95a7380305p-47; 0xed2d97cad01edp-50; 0x11deba2bdee67p-46; 0x58c8aa2784c51p-48; 0x1b96171cce3cf1p-50; 0x1bbd885d0deefp-48]%float)]%nat.
