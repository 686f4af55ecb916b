-- Change of each figure over the whole range of a key of profiles/studies/pnrvsa.toml: docs/study.md.
-- fusee query out/pnrvsa "$(cat docs/study.sql)"
-- The slope of a straight line times the range: the keys of a Sobol sequence hardly depend on each other.
WITH figures AS (SELECT *, dead_band_overdrive_deg AS band, k_pe_tension_N AS pe_N, k_se_tension_N AS se_N, joint_torque_Nm AS torque,
    shop_arm_error_percent AS arm FROM designs WHERE outcome = 'made' AND dead_band_overdrive_deg IS NOT NULL),
keys AS (
    SELECT 1 AS place, 'rig.capstan_radius_mm' AS key, rig_capstan_radius_mm AS x, * FROM figures
    UNION ALL SELECT 2, 'law.k_per_Nm_rad', law_k_per_Nm_rad, * FROM figures
    UNION ALL SELECT 3, 'law.c_Nm', law_c_Nm, * FROM figures
    UNION ALL SELECT 4, 'k_pe.spring.rate_N_per_m', k_pe_spring_rate_N_per_m, * FROM figures
    UNION ALL SELECT 5, 'k_pe.spring.preload_mm', k_pe_spring_preload_mm, * FROM figures
    UNION ALL SELECT 6, 'k_se.spring.rate_Nm_per_rad', k_se_spring_rate_Nm_per_rad, * FROM figures
    UNION ALL SELECT 7, 'k_se.spring.preload_rad', k_se_spring_preload_rad, * FROM figures),
slopes AS (SELECT place, key, (max(x) - min(x))/(avg(x*x) - avg(x)*avg(x)) AS over_range, avg(x) AS x,
    avg(x*band) AS x_band, avg(band) AS band, avg(x*mass_g) AS x_mass, avg(mass_g) AS mass, avg(x*pe_N) AS x_pe_N, avg(pe_N) AS pe_N,
    avg(x*se_N) AS x_se_N, avg(se_N) AS se_N, avg(x*torque) AS x_torque, avg(torque) AS torque, avg(x*arm) AS x_arm, avg(arm) AS arm
    FROM keys GROUP BY place)
SELECT 'mean' AS key, round(band, 1) AS band_deg, round(mass, 1) AS mass_g, CAST(round(pe_N) AS INTEGER) AS k_pe_N, round(se_N, 1) AS k_se_N,
    round(torque, 3) AS torque_Nm, round(arm, 1) AS arm_error_percent FROM slopes WHERE place = 1
UNION ALL SELECT key, round((x_band - x*band)*over_range, 1), round((x_mass - x*mass)*over_range, 1), CAST(round((x_pe_N - x*pe_N)*over_range) AS INTEGER),
    round((x_se_N - x*se_N)*over_range, 1), round((x_torque - x*torque)*over_range, 3), round((x_arm - x*arm)*over_range, 1) FROM slopes
