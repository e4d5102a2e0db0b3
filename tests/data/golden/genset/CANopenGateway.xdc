<?xml version="1.0" encoding="UTF-8"?>
<ISO15745ProfileContainer xmlns="http://www.canopen.org/xml/1.1" xmlns:co="http://www.canopen.org/xml/1.1" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance">
  <ISO15745Profile>
    <ProfileHeader xmlns="">
      <ProfileIdentification>CANopen device profile</ProfileIdentification>
      <ProfileRevision>1.1</ProfileRevision>
      <ProfileName></ProfileName>
      <ProfileSource></ProfileSource>
      <ProfileClassID>Device</ProfileClassID>
      <ISO15745Reference>
        <ISO15745Part>1</ISO15745Part>
        <ISO15745Edition>1</ISO15745Edition>
        <ProfileTechnology>CANopen</ProfileTechnology>
      </ISO15745Reference>
    </ProfileHeader>
    <ProfileBody xmlns="" xsi:type="co:ProfileBody_Device_CANopen" formatName="CANopen" formatVersion="1.0" fileName="CANopenGateway.xdc" fileCreator="Commissioning, engine room" fileCreationDate="2026-03-01" fileCreationTime="00:00:00" fileModifiedBy="Commissioning, engine room" fileModificationDate="2026-03-01" fileModificationTime="00:00:00" fileVersion="1.2" supportedLanguages="en">
      <co:DeviceIdentity>
        <co:vendorName>Heinzmann GmbH &amp; Co. KG</co:vendorName>
        <co:vendorID>0x00000161</co:vendorID>
        <co:productName>CANopen Gateway</co:productName>
        <co:productID>0x00001B59</co:productID>
        <co:productText>
          <description lang="en">Genset 2, starboard, configuration d4dc49f089f420e1</description>
        </co:productText>
        <co:orderNumber>CANopen Gateway</co:orderNumber>
        <co:version versionType="FW">0x00000068</co:version>
      </co:DeviceIdentity>
      <co:DeviceManager/>
      <co:DeviceFunction>
        <co:capabilities>
          <co:characteristicsList>
            <co:characteristic>
              <co:characteristicName>
                <label lang="en">Protocol</label>
              </co:characteristicName>
              <co:characteristicContent>
                <label lang="en">CANopen</label>
              </co:characteristicContent>
            </co:characteristic>
            <co:characteristic>
              <co:characteristicName>
                <label lang="en">Comments</label>
              </co:characteristicName>
              <co:characteristicContent>
                <label lang="en">2003h and 2004h are written by receive PDOs only: the SDO server refuses to write them</label>
              </co:characteristicContent>
              <co:characteristicContent>
                <label lang="en">Entries of 2001h, 2002h and 2004h carry the names of the governor parameters behind them</label>
              </co:characteristicContent>
            </co:characteristic>
          </co:characteristicsList>
        </co:capabilities>
      </co:DeviceFunction>
      <co:ApplicationProcess>
        <co:parameterList>
          <co:parameter uniqueID="UID_OBJ_1000" access="read">
            <label lang="en">Device Type</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_OBJ_1001" access="read">
            <label lang="en">Error Register</label>
            <USINT/>
            <co:defaultValue value="0x00"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_101600" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x01"/>
            <co:defaultValue value="0x01"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_101601" access="read">
            <label lang="en">Consumer Heartbeat Time</label>
            <UDINT/>
            <co:actualValue value="0x000107D0"/>
            <co:defaultValue value="0x000107D0"/>
          </co:parameter>
          <co:parameter uniqueID="UID_OBJ_1017" access="read">
            <label lang="en">Producer Heartbeat Time</label>
            <UINT/>
            <co:actualValue value="0x0320"/>
            <co:defaultValue value="0x0320"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_101800" access="read">
            <label lang="en">Number of entries</label>
            <USINT/>
            <co:actualValue value="0x04"/>
            <co:defaultValue value="0x04"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_101801" access="read">
            <label lang="en">Vendor ID</label>
            <UDINT/>
            <co:actualValue value="0x00000161"/>
            <co:defaultValue value="0x00000161"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_101802" access="read">
            <label lang="en">Product Code</label>
            <UDINT/>
            <co:actualValue value="0x00001B59"/>
            <co:defaultValue value="0x00001B59"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_101803" access="read">
            <label lang="en">Revision Number</label>
            <UDINT/>
            <co:actualValue value="0x00000068"/>
            <co:defaultValue value="0x00000068"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_101804" access="read">
            <label lang="en">Serial Number</label>
            <UDINT/>
            <co:actualValue value="0x019704A2"/>
            <co:defaultValue value="0x019704A2"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_120000" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x02"/>
            <co:defaultValue value="0x02"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_120001" access="read">
            <label lang="en">COB-ID Client -&gt; Server</label>
            <UDINT/>
            <co:actualValue value="0x0000060C"/>
            <co:defaultValue value="0x0000060C"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_120002" access="read">
            <label lang="en">COB-ID Server -&gt; Client</label>
            <UDINT/>
            <co:actualValue value="0x0000058C"/>
            <co:defaultValue value="0x0000058C"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140000" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x05"/>
            <co:defaultValue value="0x05"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140001" access="read">
            <label lang="en">COB-ID</label>
            <UDINT/>
            <co:actualValue value="0x0000020C"/>
            <co:defaultValue value="0x0000020C"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140002" access="read">
            <label lang="en">Transmission Type</label>
            <USINT/>
            <co:actualValue value="0xFE"/>
            <co:defaultValue value="0xFE"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140003" access="read">
            <label lang="en">Inhibit Time</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140004" access="read">
            <label lang="en">Compatibility Entry</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140005" access="read">
            <label lang="en">Event Timer</label>
            <UINT/>
            <co:actualValue value="0x01F4"/>
            <co:defaultValue value="0x01F4"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140100" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x05"/>
            <co:defaultValue value="0x05"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140101" access="read">
            <label lang="en">COB-ID</label>
            <UDINT/>
            <co:actualValue value="0x0000030C"/>
            <co:defaultValue value="0x0000030C"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140102" access="read">
            <label lang="en">Transmission Type</label>
            <USINT/>
            <co:actualValue value="0xFE"/>
            <co:defaultValue value="0xFE"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140103" access="read">
            <label lang="en">Inhibit Time</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140104" access="read">
            <label lang="en">Compatibility Entry</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140105" access="read">
            <label lang="en">Event Timer</label>
            <UINT/>
            <co:actualValue value="0x01F4"/>
            <co:defaultValue value="0x01F4"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140200" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x05"/>
            <co:defaultValue value="0x05"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140201" access="read">
            <label lang="en">COB-ID</label>
            <UDINT/>
            <co:actualValue value="0x0000040C"/>
            <co:defaultValue value="0x0000040C"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140202" access="read">
            <label lang="en">Transmission Type</label>
            <USINT/>
            <co:actualValue value="0xFE"/>
            <co:defaultValue value="0xFE"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140203" access="read">
            <label lang="en">Inhibit Time</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140204" access="read">
            <label lang="en">Compatibility Entry</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140205" access="read">
            <label lang="en">Event Timer</label>
            <UINT/>
            <co:actualValue value="0x03E8"/>
            <co:defaultValue value="0x03E8"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140300" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x05"/>
            <co:defaultValue value="0x05"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140301" access="read">
            <label lang="en">COB-ID</label>
            <UDINT/>
            <co:actualValue value="0x0000050C"/>
            <co:defaultValue value="0x0000050C"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140302" access="read">
            <label lang="en">Transmission Type</label>
            <USINT/>
            <co:actualValue value="0xFE"/>
            <co:defaultValue value="0xFE"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140303" access="read">
            <label lang="en">Inhibit Time</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140304" access="read">
            <label lang="en">Compatibility Entry</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_140305" access="read">
            <label lang="en">Event Timer</label>
            <UINT/>
            <co:actualValue value="0x03E8"/>
            <co:defaultValue value="0x03E8"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_160000" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x03"/>
            <co:defaultValue value="0x03"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x00"/>
                <maxValue value="0x03"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_160001" access="read">
            <label lang="en">Mapped Object 1</label>
            <UDINT/>
            <co:actualValue value="0x20030110"/>
            <co:defaultValue value="0x20030110"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_160002" access="read">
            <label lang="en">Mapped Object 2</label>
            <UDINT/>
            <co:actualValue value="0x00060010"/>
            <co:defaultValue value="0x00060010"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_160003" access="read">
            <label lang="en">Mapped Object 3</label>
            <UDINT/>
            <co:actualValue value="0x20030210"/>
            <co:defaultValue value="0x20030210"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_160100" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x03"/>
            <co:defaultValue value="0x03"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x00"/>
                <maxValue value="0x04"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_160101" access="read">
            <label lang="en">Mapped Object 1</label>
            <UDINT/>
            <co:actualValue value="0x20040110"/>
            <co:defaultValue value="0x20040110"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_160102" access="read">
            <label lang="en">Mapped Object 2</label>
            <UDINT/>
            <co:actualValue value="0x20040210"/>
            <co:defaultValue value="0x20040210"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_160103" access="read">
            <label lang="en">Mapped Object 3</label>
            <UDINT/>
            <co:actualValue value="0x20040310"/>
            <co:defaultValue value="0x20040310"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_160104" access="read">
            <label lang="en">Mapped Object 4</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_160200" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x02"/>
            <co:defaultValue value="0x02"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x00"/>
                <maxValue value="0x04"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_160201" access="read">
            <label lang="en">Mapped Object 1</label>
            <UDINT/>
            <co:actualValue value="0x20040510"/>
            <co:defaultValue value="0x20040510"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_160202" access="read">
            <label lang="en">Mapped Object 2</label>
            <UDINT/>
            <co:actualValue value="0x20040610"/>
            <co:defaultValue value="0x20040610"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_160203" access="read">
            <label lang="en">Mapped Object 3</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_160204" access="read">
            <label lang="en">Mapped Object 4</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_160300" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x01"/>
            <co:defaultValue value="0x01"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x00"/>
                <maxValue value="0x04"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_160301" access="read">
            <label lang="en">Mapped Object 1</label>
            <UDINT/>
            <co:actualValue value="0x20040910"/>
            <co:defaultValue value="0x20040910"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_160302" access="read">
            <label lang="en">Mapped Object 2</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_160303" access="read">
            <label lang="en">Mapped Object 3</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_160304" access="read">
            <label lang="en">Mapped Object 4</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180000" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x05"/>
            <co:defaultValue value="0x05"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180001" access="read">
            <label lang="en">COB-ID</label>
            <UDINT/>
            <co:actualValue value="0x0000018C"/>
            <co:defaultValue value="0x0000018C"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180002" access="read">
            <label lang="en">Transmission Type</label>
            <USINT/>
            <co:actualValue value="0xFE"/>
            <co:defaultValue value="0xFE"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180003" access="read">
            <label lang="en">Inhibit Time</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180004" access="read">
            <label lang="en">Compatibility Entry</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180005" access="read">
            <label lang="en">Event Timer</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180100" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x05"/>
            <co:defaultValue value="0x05"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180101" access="read">
            <label lang="en">COB-ID</label>
            <UDINT/>
            <co:actualValue value="0x0000028C"/>
            <co:defaultValue value="0x0000028C"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180102" access="read">
            <label lang="en">Transmission Type</label>
            <USINT/>
            <co:actualValue value="0xFE"/>
            <co:defaultValue value="0xFE"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180103" access="read">
            <label lang="en">Inhibit Time</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180104" access="read">
            <label lang="en">Compatibility Entry</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180105" access="read">
            <label lang="en">Event Timer</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180200" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x05"/>
            <co:defaultValue value="0x05"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180201" access="read">
            <label lang="en">COB-ID</label>
            <UDINT/>
            <co:actualValue value="0x0000038C"/>
            <co:defaultValue value="0x0000038C"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180202" access="read">
            <label lang="en">Transmission Type</label>
            <USINT/>
            <co:actualValue value="0xFE"/>
            <co:defaultValue value="0xFE"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180203" access="read">
            <label lang="en">Inhibit Time</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180204" access="read">
            <label lang="en">Compatibility Entry</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180205" access="read">
            <label lang="en">Event Timer</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180300" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x05"/>
            <co:defaultValue value="0x05"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180301" access="read">
            <label lang="en">COB-ID</label>
            <UDINT/>
            <co:actualValue value="0x0000048C"/>
            <co:defaultValue value="0x0000048C"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180302" access="read">
            <label lang="en">Transmission Type</label>
            <USINT/>
            <co:actualValue value="0xFE"/>
            <co:defaultValue value="0xFE"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180303" access="read">
            <label lang="en">Inhibit Time</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180304" access="read">
            <label lang="en">Compatibility Entry</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180305" access="read">
            <label lang="en">Event Timer</label>
            <UINT/>
            <co:actualValue value="0x007D"/>
            <co:defaultValue value="0x007D"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180400" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x05"/>
            <co:defaultValue value="0x05"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180401" access="read">
            <label lang="en">COB-ID</label>
            <UDINT/>
            <co:actualValue value="0x00000680"/>
            <co:defaultValue value="0x00000680"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180402" access="read">
            <label lang="en">Transmission Type</label>
            <USINT/>
            <co:actualValue value="0xFE"/>
            <co:defaultValue value="0xFE"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180403" access="read">
            <label lang="en">Inhibit Time</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180404" access="read">
            <label lang="en">Compatibility Entry</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180405" access="read">
            <label lang="en">Event Timer</label>
            <UINT/>
            <co:actualValue value="0x01F4"/>
            <co:defaultValue value="0x01F4"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180500" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x05"/>
            <co:defaultValue value="0x05"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180501" access="read">
            <label lang="en">COB-ID</label>
            <UDINT/>
            <co:actualValue value="0x00000681"/>
            <co:defaultValue value="0x00000681"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180502" access="read">
            <label lang="en">Transmission Type</label>
            <USINT/>
            <co:actualValue value="0xFE"/>
            <co:defaultValue value="0xFE"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180503" access="read">
            <label lang="en">Inhibit Time</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180504" access="read">
            <label lang="en">Compatibility Entry</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180505" access="read">
            <label lang="en">Event Timer</label>
            <UINT/>
            <co:actualValue value="0x03E8"/>
            <co:defaultValue value="0x03E8"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180600" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x05"/>
            <co:defaultValue value="0x05"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180601" access="read">
            <label lang="en">COB-ID</label>
            <UDINT/>
            <co:actualValue value="0x80000000"/>
            <co:defaultValue value="0x80000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180602" access="read">
            <label lang="en">Transmission Type</label>
            <USINT/>
            <co:actualValue value="0xFE"/>
            <co:defaultValue value="0xFE"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180603" access="read">
            <label lang="en">Inhibit Time</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180604" access="read">
            <label lang="en">Compatibility Entry</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180605" access="read">
            <label lang="en">Event Timer</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180700" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x05"/>
            <co:defaultValue value="0x05"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180701" access="read">
            <label lang="en">COB-ID</label>
            <UDINT/>
            <co:actualValue value="0x80000000"/>
            <co:defaultValue value="0x80000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180702" access="read">
            <label lang="en">Transmission Type</label>
            <USINT/>
            <co:actualValue value="0xFE"/>
            <co:defaultValue value="0xFE"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180703" access="read">
            <label lang="en">Inhibit Time</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180704" access="read">
            <label lang="en">Compatibility Entry</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180705" access="read">
            <label lang="en">Event Timer</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180800" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x05"/>
            <co:defaultValue value="0x05"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180801" access="read">
            <label lang="en">COB-ID</label>
            <UDINT/>
            <co:actualValue value="0x80000000"/>
            <co:defaultValue value="0x80000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180802" access="read">
            <label lang="en">Transmission Type</label>
            <USINT/>
            <co:actualValue value="0xFE"/>
            <co:defaultValue value="0xFE"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180803" access="read">
            <label lang="en">Inhibit Time</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180804" access="read">
            <label lang="en">Compatibility Entry</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180805" access="read">
            <label lang="en">Event Timer</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180900" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x05"/>
            <co:defaultValue value="0x05"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180901" access="read">
            <label lang="en">COB-ID</label>
            <UDINT/>
            <co:actualValue value="0x80000000"/>
            <co:defaultValue value="0x80000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180902" access="read">
            <label lang="en">Transmission Type</label>
            <USINT/>
            <co:actualValue value="0xFE"/>
            <co:defaultValue value="0xFE"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180903" access="read">
            <label lang="en">Inhibit Time</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180904" access="read">
            <label lang="en">Compatibility Entry</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180905" access="read">
            <label lang="en">Event Timer</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180A00" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x05"/>
            <co:defaultValue value="0x05"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180A01" access="read">
            <label lang="en">COB-ID</label>
            <UDINT/>
            <co:actualValue value="0x80000000"/>
            <co:defaultValue value="0x80000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180A02" access="read">
            <label lang="en">Transmission Type</label>
            <USINT/>
            <co:actualValue value="0xFE"/>
            <co:defaultValue value="0xFE"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180A03" access="read">
            <label lang="en">Inhibit Time</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180A04" access="read">
            <label lang="en">Compatibility Entry</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180A05" access="read">
            <label lang="en">Event Timer</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180B00" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x05"/>
            <co:defaultValue value="0x05"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180B01" access="read">
            <label lang="en">COB-ID</label>
            <UDINT/>
            <co:actualValue value="0x80000000"/>
            <co:defaultValue value="0x80000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180B02" access="read">
            <label lang="en">Transmission Type</label>
            <USINT/>
            <co:actualValue value="0xFE"/>
            <co:defaultValue value="0xFE"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180B03" access="read">
            <label lang="en">Inhibit Time</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180B04" access="read">
            <label lang="en">Compatibility Entry</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180B05" access="read">
            <label lang="en">Event Timer</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180C00" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x05"/>
            <co:defaultValue value="0x05"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180C01" access="read">
            <label lang="en">COB-ID</label>
            <UDINT/>
            <co:actualValue value="0x80000000"/>
            <co:defaultValue value="0x80000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180C02" access="read">
            <label lang="en">Transmission Type</label>
            <USINT/>
            <co:actualValue value="0xFE"/>
            <co:defaultValue value="0xFE"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180C03" access="read">
            <label lang="en">Inhibit Time</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180C04" access="read">
            <label lang="en">Compatibility Entry</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180C05" access="read">
            <label lang="en">Event Timer</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180D00" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x05"/>
            <co:defaultValue value="0x05"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180D01" access="read">
            <label lang="en">COB-ID</label>
            <UDINT/>
            <co:actualValue value="0x80000000"/>
            <co:defaultValue value="0x80000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180D02" access="read">
            <label lang="en">Transmission Type</label>
            <USINT/>
            <co:actualValue value="0xFE"/>
            <co:defaultValue value="0xFE"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180D03" access="read">
            <label lang="en">Inhibit Time</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180D04" access="read">
            <label lang="en">Compatibility Entry</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180D05" access="read">
            <label lang="en">Event Timer</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180E00" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x05"/>
            <co:defaultValue value="0x05"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180E01" access="read">
            <label lang="en">COB-ID</label>
            <UDINT/>
            <co:actualValue value="0x80000000"/>
            <co:defaultValue value="0x80000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180E02" access="read">
            <label lang="en">Transmission Type</label>
            <USINT/>
            <co:actualValue value="0xFE"/>
            <co:defaultValue value="0xFE"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180E03" access="read">
            <label lang="en">Inhibit Time</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180E04" access="read">
            <label lang="en">Compatibility Entry</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180E05" access="read">
            <label lang="en">Event Timer</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180F00" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x05"/>
            <co:defaultValue value="0x05"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180F01" access="read">
            <label lang="en">COB-ID</label>
            <UDINT/>
            <co:actualValue value="0x80000000"/>
            <co:defaultValue value="0x80000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180F02" access="read">
            <label lang="en">Transmission Type</label>
            <USINT/>
            <co:actualValue value="0xFE"/>
            <co:defaultValue value="0xFE"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180F03" access="read">
            <label lang="en">Inhibit Time</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180F04" access="read">
            <label lang="en">Compatibility Entry</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_180F05" access="read">
            <label lang="en">Event Timer</label>
            <UINT/>
            <co:actualValue value="0x0000"/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0000" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x04"/>
            <co:defaultValue value="0x04"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x00"/>
                <maxValue value="0x04"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0001" access="read">
            <label lang="en">Mapped Object 1</label>
            <UDINT/>
            <co:actualValue value="0x20000110"/>
            <co:defaultValue value="0x20000110"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0002" access="read">
            <label lang="en">Mapped Object 2</label>
            <UDINT/>
            <co:actualValue value="0x20000210"/>
            <co:defaultValue value="0x20000210"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0003" access="read">
            <label lang="en">Mapped Object 3</label>
            <UDINT/>
            <co:actualValue value="0x20000310"/>
            <co:defaultValue value="0x20000310"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0004" access="read">
            <label lang="en">Mapped Object 4</label>
            <UDINT/>
            <co:actualValue value="0x20000410"/>
            <co:defaultValue value="0x20000410"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0100" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x02"/>
            <co:defaultValue value="0x02"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x00"/>
                <maxValue value="0x02"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0101" access="read">
            <label lang="en">Mapped Object 1</label>
            <UDINT/>
            <co:actualValue value="0x20000510"/>
            <co:defaultValue value="0x20000510"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0102" access="read">
            <label lang="en">Mapped Object 2</label>
            <UDINT/>
            <co:actualValue value="0x20000610"/>
            <co:defaultValue value="0x20000610"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0200" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x01"/>
            <co:defaultValue value="0x01"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x00"/>
                <maxValue value="0x01"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0201" access="read">
            <label lang="en">Mapped Object 1</label>
            <UDINT/>
            <co:actualValue value="0x20000710"/>
            <co:defaultValue value="0x20000710"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0300" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x04"/>
            <co:defaultValue value="0x04"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x00"/>
                <maxValue value="0x04"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0301" access="read">
            <label lang="en">Mapped Object 1</label>
            <UDINT/>
            <co:actualValue value="0x20010110"/>
            <co:defaultValue value="0x20010110"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0302" access="read">
            <label lang="en">Mapped Object 2</label>
            <UDINT/>
            <co:actualValue value="0x20010210"/>
            <co:defaultValue value="0x20010210"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0303" access="read">
            <label lang="en">Mapped Object 3</label>
            <UDINT/>
            <co:actualValue value="0x20010310"/>
            <co:defaultValue value="0x20010310"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0304" access="read">
            <label lang="en">Mapped Object 4</label>
            <UDINT/>
            <co:actualValue value="0x20010410"/>
            <co:defaultValue value="0x20010410"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0400" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x04"/>
            <co:defaultValue value="0x04"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x00"/>
                <maxValue value="0x04"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0401" access="read">
            <label lang="en">Mapped Object 1</label>
            <UDINT/>
            <co:actualValue value="0x20010510"/>
            <co:defaultValue value="0x20010510"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0402" access="read">
            <label lang="en">Mapped Object 2</label>
            <UDINT/>
            <co:actualValue value="0x20010610"/>
            <co:defaultValue value="0x20010610"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0403" access="read">
            <label lang="en">Mapped Object 3</label>
            <UDINT/>
            <co:actualValue value="0x20010710"/>
            <co:defaultValue value="0x20010710"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0404" access="read">
            <label lang="en">Mapped Object 4</label>
            <UDINT/>
            <co:actualValue value="0x20010810"/>
            <co:defaultValue value="0x20010810"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0500" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x04"/>
            <co:defaultValue value="0x04"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x00"/>
                <maxValue value="0x04"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0501" access="read">
            <label lang="en">Mapped Object 1</label>
            <UDINT/>
            <co:actualValue value="0x20010910"/>
            <co:defaultValue value="0x20010910"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0502" access="read">
            <label lang="en">Mapped Object 2</label>
            <UDINT/>
            <co:actualValue value="0x20010A10"/>
            <co:defaultValue value="0x20010A10"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0503" access="read">
            <label lang="en">Mapped Object 3</label>
            <UDINT/>
            <co:actualValue value="0x20010B10"/>
            <co:defaultValue value="0x20010B10"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0504" access="read">
            <label lang="en">Mapped Object 4</label>
            <UDINT/>
            <co:actualValue value="0x20010C10"/>
            <co:defaultValue value="0x20010C10"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0600" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x00"/>
                <maxValue value="0x04"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0601" access="read">
            <label lang="en">Mapped Object 1</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0602" access="read">
            <label lang="en">Mapped Object 2</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0603" access="read">
            <label lang="en">Mapped Object 3</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0604" access="read">
            <label lang="en">Mapped Object 4</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0700" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x00"/>
                <maxValue value="0x04"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0701" access="read">
            <label lang="en">Mapped Object 1</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0702" access="read">
            <label lang="en">Mapped Object 2</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0703" access="read">
            <label lang="en">Mapped Object 3</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0704" access="read">
            <label lang="en">Mapped Object 4</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0800" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x00"/>
                <maxValue value="0x04"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0801" access="read">
            <label lang="en">Mapped Object 1</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0802" access="read">
            <label lang="en">Mapped Object 2</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0803" access="read">
            <label lang="en">Mapped Object 3</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0804" access="read">
            <label lang="en">Mapped Object 4</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0900" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x00"/>
                <maxValue value="0x04"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0901" access="read">
            <label lang="en">Mapped Object 1</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0902" access="read">
            <label lang="en">Mapped Object 2</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0903" access="read">
            <label lang="en">Mapped Object 3</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0904" access="read">
            <label lang="en">Mapped Object 4</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0A00" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x00"/>
                <maxValue value="0x04"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0A01" access="read">
            <label lang="en">Mapped Object 1</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0A02" access="read">
            <label lang="en">Mapped Object 2</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0A03" access="read">
            <label lang="en">Mapped Object 3</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0A04" access="read">
            <label lang="en">Mapped Object 4</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0B00" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x00"/>
                <maxValue value="0x04"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0B01" access="read">
            <label lang="en">Mapped Object 1</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0B02" access="read">
            <label lang="en">Mapped Object 2</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0B03" access="read">
            <label lang="en">Mapped Object 3</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0B04" access="read">
            <label lang="en">Mapped Object 4</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0C00" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x00"/>
                <maxValue value="0x04"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0C01" access="read">
            <label lang="en">Mapped Object 1</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0C02" access="read">
            <label lang="en">Mapped Object 2</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0C03" access="read">
            <label lang="en">Mapped Object 3</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0C04" access="read">
            <label lang="en">Mapped Object 4</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0D00" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x00"/>
                <maxValue value="0x04"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0D01" access="read">
            <label lang="en">Mapped Object 1</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0D02" access="read">
            <label lang="en">Mapped Object 2</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0D03" access="read">
            <label lang="en">Mapped Object 3</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0D04" access="read">
            <label lang="en">Mapped Object 4</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0E00" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x00"/>
                <maxValue value="0x04"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0E01" access="read">
            <label lang="en">Mapped Object 1</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0E02" access="read">
            <label lang="en">Mapped Object 2</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0E03" access="read">
            <label lang="en">Mapped Object 3</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0E04" access="read">
            <label lang="en">Mapped Object 4</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0F00" access="read">
            <label lang="en">Number of Entries</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x00"/>
                <maxValue value="0x04"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0F01" access="read">
            <label lang="en">Mapped Object 1</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0F02" access="read">
            <label lang="en">Mapped Object 2</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0F03" access="read">
            <label lang="en">Mapped Object 3</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_1A0F04" access="read">
            <label lang="en">Mapped Object 4</label>
            <UDINT/>
            <co:actualValue value="0x00000000"/>
            <co:defaultValue value="0x00000000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200000" access="read">
            <label lang="en">Number of entries</label>
            <USINT/>
            <co:actualValue value="0x07"/>
            <co:defaultValue value="0x07"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x06"/>
                <maxValue value="0x07"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200001" access="read">
            <label lang="en">Errors 0-15</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200002" access="read">
            <label lang="en">Errors 16-31</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200003" access="read">
            <label lang="en">Errors 32-47</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200004" access="read">
            <label lang="en">Errors 48-63</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200005" access="read">
            <label lang="en">Errors 64-79</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200006" access="read">
            <label lang="en">Errors 80-95</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200007" access="read">
            <label lang="en">Engine State</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200100" access="read">
            <label lang="en">Number of entries</label>
            <USINT/>
            <co:actualValue value="0x0C"/>
            <co:defaultValue value="0x0C"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x00"/>
                <maxValue value="0x34"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200101" access="read">
            <label lang="en">Speed</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200102" access="read">
            <label lang="en">SpeedSetp</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200103" access="read">
            <label lang="en">ActPos</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200104" access="read">
            <label lang="en">MeasuredPower</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200105" access="read">
            <label lang="en">BoostPressure</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200106" access="read">
            <label lang="en">OilPressure</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200107" access="read">
            <label lang="en">AmbientPressure</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200108" access="read">
            <label lang="en">CoolantPressure</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200109" access="read">
            <label lang="en">CoolantTemp</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_20010A" access="read">
            <label lang="en">ChargeAirTemp</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_20010B" access="read">
            <label lang="en">OilTemp</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_20010C" access="read">
            <label lang="en">ExhaustTemp</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200200" access="read">
            <label lang="en">Number of entries</label>
            <USINT/>
            <co:actualValue value="0x00"/>
            <co:defaultValue value="0x00"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x00"/>
                <maxValue value="0x34"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200300" access="read">
            <label lang="en">Number of entries</label>
            <USINT/>
            <co:actualValue value="0x02"/>
            <co:defaultValue value="0x02"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x00"/>
                <maxValue value="0x02"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200301" access="readWriteOutput">
            <label lang="en">Switch Functions</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200302" access="readWriteOutput">
            <label lang="en">Sensor Error Flags</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200400" access="read">
            <label lang="en">Number of entries</label>
            <USINT/>
            <co:actualValue value="0x09"/>
            <co:defaultValue value="0x09"/>
            <co:allowedValues>
              <co:range>
                <minValue value="0x00"/>
                <maxValue value="0x0C"/>
              </co:range>
            </co:allowedValues>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200401" access="readWriteOutput">
            <label lang="en">AssignIn_Setp1Ext</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200402" access="readWriteOutput">
            <label lang="en">Sensor 902</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200403" access="readWriteOutput">
            <label lang="en">Sensor 903</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200404" access="readWriteOutput">
            <label lang="en">Unused Channel 4</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200405" access="readWriteOutput">
            <label lang="en">AssignIn_AmbPress</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200406" access="readWriteOutput">
            <label lang="en">Sensor 910</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200407" access="readWriteOutput">
            <label lang="en">Unused Channel 7</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200408" access="readWriteOutput">
            <label lang="en">Unused Channel 8</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_SUB_200409" access="readWriteOutput">
            <label lang="en">AssignIn_CurrentLoad</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
          <co:parameter uniqueID="UID_OBJ_2005" access="read">
            <label lang="en">CanOpen Errors</label>
            <UINT/>
            <co:defaultValue value="0x0000"/>
          </co:parameter>
        </co:parameterList>
      </co:ApplicationProcess>
    </ProfileBody>
  </ISO15745Profile>
  <ISO15745Profile>
    <ProfileHeader xmlns="">
      <ProfileIdentification>CANopen communication network profile</ProfileIdentification>
      <ProfileRevision>1.1</ProfileRevision>
      <ProfileName></ProfileName>
      <ProfileSource></ProfileSource>
      <ProfileClassID>CommunicationNetwork</ProfileClassID>
      <ISO15745Reference>
        <ISO15745Part>1</ISO15745Part>
        <ISO15745Edition>1</ISO15745Edition>
        <ProfileTechnology>CANopen</ProfileTechnology>
      </ISO15745Reference>
    </ProfileHeader>
    <ProfileBody xmlns="" xsi:type="co:ProfileBody_CommunicationNetwork_CANopen" formatName="CANopen" formatVersion="1.0" fileName="CANopenGateway.xdc" fileCreator="Commissioning, engine room" fileCreationDate="2026-03-01" fileCreationTime="00:00:00" fileModifiedBy="Commissioning, engine room" fileModificationDate="2026-03-01" fileModificationTime="00:00:00" fileVersion="1.2" supportedLanguages="en">
      <ApplicationLayers>
        <co:CANopenObjectList mandatoryObjects="3" optionalObjects="43" manufacturerObjects="6">
          <CANopenObject index="1000" name="Device Type" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_OBJ_1000"/>
          <CANopenObject index="1001" name="Error Register" objectType="7" dataType="0005" accessType="ro" defaultValue="0x00" PDOmapping="no" uniqueIDRef="UID_OBJ_1001"/>
          <CANopenObject index="1016" name="Consumer Heartbeat Time" objectType="8" subNumber="2">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" accessType="ro" defaultValue="0x01" actualValue="0x01" PDOmapping="no" uniqueIDRef="UID_SUB_101600"/>
            <CANopenSubObject subIndex="01" name="Consumer Heartbeat Time" objectType="7" dataType="0007" accessType="ro" defaultValue="0x000107D0" actualValue="0x000107D0" PDOmapping="no" uniqueIDRef="UID_SUB_101601"/>
          </CANopenObject>
          <CANopenObject index="1017" name="Producer Heartbeat Time" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0320" actualValue="0x0320" PDOmapping="no" uniqueIDRef="UID_OBJ_1017"/>
          <CANopenObject index="1018" name="Identity Object" objectType="9" subNumber="5">
            <CANopenSubObject subIndex="00" name="Number of entries" objectType="7" dataType="0005" accessType="ro" defaultValue="0x04" actualValue="0x04" PDOmapping="no" uniqueIDRef="UID_SUB_101800"/>
            <CANopenSubObject subIndex="01" name="Vendor ID" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000161" actualValue="0x00000161" PDOmapping="no" uniqueIDRef="UID_SUB_101801"/>
            <CANopenSubObject subIndex="02" name="Product Code" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00001B59" actualValue="0x00001B59" PDOmapping="no" uniqueIDRef="UID_SUB_101802"/>
            <CANopenSubObject subIndex="03" name="Revision Number" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000068" actualValue="0x00000068" PDOmapping="no" uniqueIDRef="UID_SUB_101803"/>
            <CANopenSubObject subIndex="04" name="Serial Number" objectType="7" dataType="0007" accessType="ro" defaultValue="0x019704A2" actualValue="0x019704A2" PDOmapping="no" uniqueIDRef="UID_SUB_101804"/>
          </CANopenObject>
          <CANopenObject index="1200" name="Server SDO Parameter" objectType="9" subNumber="3">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" accessType="ro" defaultValue="0x02" actualValue="0x02" PDOmapping="no" uniqueIDRef="UID_SUB_120000"/>
            <CANopenSubObject subIndex="01" name="COB-ID Client -&gt; Server" objectType="7" dataType="0007" accessType="ro" defaultValue="0x0000060C" actualValue="0x0000060C" PDOmapping="no" uniqueIDRef="UID_SUB_120001"/>
            <CANopenSubObject subIndex="02" name="COB-ID Server -&gt; Client" objectType="7" dataType="0007" accessType="ro" defaultValue="0x0000058C" actualValue="0x0000058C" PDOmapping="no" uniqueIDRef="UID_SUB_120002"/>
          </CANopenObject>
          <CANopenObject index="1400" name="RPDO1 Communication Parameter" objectType="9" subNumber="6">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" accessType="ro" defaultValue="0x05" actualValue="0x05" PDOmapping="no" uniqueIDRef="UID_SUB_140000"/>
            <CANopenSubObject subIndex="01" name="COB-ID" objectType="7" dataType="0007" accessType="ro" defaultValue="0x0000020C" actualValue="0x0000020C" PDOmapping="no" uniqueIDRef="UID_SUB_140001"/>
            <CANopenSubObject subIndex="02" name="Transmission Type" objectType="7" dataType="0005" accessType="ro" defaultValue="0xFE" actualValue="0xFE" PDOmapping="no" uniqueIDRef="UID_SUB_140002"/>
            <CANopenSubObject subIndex="03" name="Inhibit Time" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_140003"/>
            <CANopenSubObject subIndex="04" name="Compatibility Entry" objectType="7" dataType="0005" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_140004"/>
            <CANopenSubObject subIndex="05" name="Event Timer" objectType="7" dataType="0006" accessType="ro" defaultValue="0x01F4" actualValue="0x01F4" PDOmapping="no" uniqueIDRef="UID_SUB_140005"/>
          </CANopenObject>
          <CANopenObject index="1401" name="RPDO2 Communication Parameter" objectType="9" subNumber="6">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" accessType="ro" defaultValue="0x05" actualValue="0x05" PDOmapping="no" uniqueIDRef="UID_SUB_140100"/>
            <CANopenSubObject subIndex="01" name="COB-ID" objectType="7" dataType="0007" accessType="ro" defaultValue="0x0000030C" actualValue="0x0000030C" PDOmapping="no" uniqueIDRef="UID_SUB_140101"/>
            <CANopenSubObject subIndex="02" name="Transmission Type" objectType="7" dataType="0005" accessType="ro" defaultValue="0xFE" actualValue="0xFE" PDOmapping="no" uniqueIDRef="UID_SUB_140102"/>
            <CANopenSubObject subIndex="03" name="Inhibit Time" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_140103"/>
            <CANopenSubObject subIndex="04" name="Compatibility Entry" objectType="7" dataType="0005" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_140104"/>
            <CANopenSubObject subIndex="05" name="Event Timer" objectType="7" dataType="0006" accessType="ro" defaultValue="0x01F4" actualValue="0x01F4" PDOmapping="no" uniqueIDRef="UID_SUB_140105"/>
          </CANopenObject>
          <CANopenObject index="1402" name="RPDO3 Communication Parameter" objectType="9" subNumber="6">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" accessType="ro" defaultValue="0x05" actualValue="0x05" PDOmapping="no" uniqueIDRef="UID_SUB_140200"/>
            <CANopenSubObject subIndex="01" name="COB-ID" objectType="7" dataType="0007" accessType="ro" defaultValue="0x0000040C" actualValue="0x0000040C" PDOmapping="no" uniqueIDRef="UID_SUB_140201"/>
            <CANopenSubObject subIndex="02" name="Transmission Type" objectType="7" dataType="0005" accessType="ro" defaultValue="0xFE" actualValue="0xFE" PDOmapping="no" uniqueIDRef="UID_SUB_140202"/>
            <CANopenSubObject subIndex="03" name="Inhibit Time" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_140203"/>
            <CANopenSubObject subIndex="04" name="Compatibility Entry" objectType="7" dataType="0005" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_140204"/>
            <CANopenSubObject subIndex="05" name="Event Timer" objectType="7" dataType="0006" accessType="ro" defaultValue="0x03E8" actualValue="0x03E8" PDOmapping="no" uniqueIDRef="UID_SUB_140205"/>
          </CANopenObject>
          <CANopenObject index="1403" name="RPDO4 Communication Parameter" objectType="9" subNumber="6">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" accessType="ro" defaultValue="0x05" actualValue="0x05" PDOmapping="no" uniqueIDRef="UID_SUB_140300"/>
            <CANopenSubObject subIndex="01" name="COB-ID" objectType="7" dataType="0007" accessType="ro" defaultValue="0x0000050C" actualValue="0x0000050C" PDOmapping="no" uniqueIDRef="UID_SUB_140301"/>
            <CANopenSubObject subIndex="02" name="Transmission Type" objectType="7" dataType="0005" accessType="ro" defaultValue="0xFE" actualValue="0xFE" PDOmapping="no" uniqueIDRef="UID_SUB_140302"/>
            <CANopenSubObject subIndex="03" name="Inhibit Time" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_140303"/>
            <CANopenSubObject subIndex="04" name="Compatibility Entry" objectType="7" dataType="0005" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_140304"/>
            <CANopenSubObject subIndex="05" name="Event Timer" objectType="7" dataType="0006" accessType="ro" defaultValue="0x03E8" actualValue="0x03E8" PDOmapping="no" uniqueIDRef="UID_SUB_140305"/>
          </CANopenObject>
          <CANopenObject index="1600" name="RPDO1 Mapping Parameter" objectType="9" subNumber="4">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" lowLimit="0x00" highLimit="0x03" accessType="ro" defaultValue="0x03" actualValue="0x03" PDOmapping="no" uniqueIDRef="UID_SUB_160000"/>
            <CANopenSubObject subIndex="01" name="Mapped Object 1" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20030110" actualValue="0x20030110" PDOmapping="no" uniqueIDRef="UID_SUB_160001"/>
            <CANopenSubObject subIndex="02" name="Mapped Object 2" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00060010" actualValue="0x00060010" PDOmapping="no" uniqueIDRef="UID_SUB_160002"/>
            <CANopenSubObject subIndex="03" name="Mapped Object 3" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20030210" actualValue="0x20030210" PDOmapping="no" uniqueIDRef="UID_SUB_160003"/>
          </CANopenObject>
          <CANopenObject index="1601" name="RPDO2 Mapping Parameter" objectType="9" subNumber="5">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" lowLimit="0x00" highLimit="0x04" accessType="ro" defaultValue="0x03" actualValue="0x03" PDOmapping="no" uniqueIDRef="UID_SUB_160100"/>
            <CANopenSubObject subIndex="01" name="Mapped Object 1" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20040110" actualValue="0x20040110" PDOmapping="no" uniqueIDRef="UID_SUB_160101"/>
            <CANopenSubObject subIndex="02" name="Mapped Object 2" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20040210" actualValue="0x20040210" PDOmapping="no" uniqueIDRef="UID_SUB_160102"/>
            <CANopenSubObject subIndex="03" name="Mapped Object 3" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20040310" actualValue="0x20040310" PDOmapping="no" uniqueIDRef="UID_SUB_160103"/>
            <CANopenSubObject subIndex="04" name="Mapped Object 4" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_160104"/>
          </CANopenObject>
          <CANopenObject index="1602" name="RPDO3 Mapping Parameter" objectType="9" subNumber="5">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" lowLimit="0x00" highLimit="0x04" accessType="ro" defaultValue="0x02" actualValue="0x02" PDOmapping="no" uniqueIDRef="UID_SUB_160200"/>
            <CANopenSubObject subIndex="01" name="Mapped Object 1" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20040510" actualValue="0x20040510" PDOmapping="no" uniqueIDRef="UID_SUB_160201"/>
            <CANopenSubObject subIndex="02" name="Mapped Object 2" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20040610" actualValue="0x20040610" PDOmapping="no" uniqueIDRef="UID_SUB_160202"/>
            <CANopenSubObject subIndex="03" name="Mapped Object 3" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_160203"/>
            <CANopenSubObject subIndex="04" name="Mapped Object 4" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_160204"/>
          </CANopenObject>
          <CANopenObject index="1603" name="RPDO4 Mapping Parameter" objectType="9" subNumber="5">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" lowLimit="0x00" highLimit="0x04" accessType="ro" defaultValue="0x01" actualValue="0x01" PDOmapping="no" uniqueIDRef="UID_SUB_160300"/>
            <CANopenSubObject subIndex="01" name="Mapped Object 1" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20040910" actualValue="0x20040910" PDOmapping="no" uniqueIDRef="UID_SUB_160301"/>
            <CANopenSubObject subIndex="02" name="Mapped Object 2" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_160302"/>
            <CANopenSubObject subIndex="03" name="Mapped Object 3" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_160303"/>
            <CANopenSubObject subIndex="04" name="Mapped Object 4" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_160304"/>
          </CANopenObject>
          <CANopenObject index="1800" name="TPDO1 Communication Parameter" objectType="9" subNumber="6">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" accessType="ro" defaultValue="0x05" actualValue="0x05" PDOmapping="no" uniqueIDRef="UID_SUB_180000"/>
            <CANopenSubObject subIndex="01" name="COB-ID" objectType="7" dataType="0007" accessType="ro" defaultValue="0x0000018C" actualValue="0x0000018C" PDOmapping="no" uniqueIDRef="UID_SUB_180001"/>
            <CANopenSubObject subIndex="02" name="Transmission Type" objectType="7" dataType="0005" accessType="ro" defaultValue="0xFE" actualValue="0xFE" PDOmapping="no" uniqueIDRef="UID_SUB_180002"/>
            <CANopenSubObject subIndex="03" name="Inhibit Time" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180003"/>
            <CANopenSubObject subIndex="04" name="Compatibility Entry" objectType="7" dataType="0005" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_180004"/>
            <CANopenSubObject subIndex="05" name="Event Timer" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180005"/>
          </CANopenObject>
          <CANopenObject index="1801" name="TPDO2 Communication Parameter" objectType="9" subNumber="6">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" accessType="ro" defaultValue="0x05" actualValue="0x05" PDOmapping="no" uniqueIDRef="UID_SUB_180100"/>
            <CANopenSubObject subIndex="01" name="COB-ID" objectType="7" dataType="0007" accessType="ro" defaultValue="0x0000028C" actualValue="0x0000028C" PDOmapping="no" uniqueIDRef="UID_SUB_180101"/>
            <CANopenSubObject subIndex="02" name="Transmission Type" objectType="7" dataType="0005" accessType="ro" defaultValue="0xFE" actualValue="0xFE" PDOmapping="no" uniqueIDRef="UID_SUB_180102"/>
            <CANopenSubObject subIndex="03" name="Inhibit Time" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180103"/>
            <CANopenSubObject subIndex="04" name="Compatibility Entry" objectType="7" dataType="0005" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_180104"/>
            <CANopenSubObject subIndex="05" name="Event Timer" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180105"/>
          </CANopenObject>
          <CANopenObject index="1802" name="TPDO3 Communication Parameter" objectType="9" subNumber="6">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" accessType="ro" defaultValue="0x05" actualValue="0x05" PDOmapping="no" uniqueIDRef="UID_SUB_180200"/>
            <CANopenSubObject subIndex="01" name="COB-ID" objectType="7" dataType="0007" accessType="ro" defaultValue="0x0000038C" actualValue="0x0000038C" PDOmapping="no" uniqueIDRef="UID_SUB_180201"/>
            <CANopenSubObject subIndex="02" name="Transmission Type" objectType="7" dataType="0005" accessType="ro" defaultValue="0xFE" actualValue="0xFE" PDOmapping="no" uniqueIDRef="UID_SUB_180202"/>
            <CANopenSubObject subIndex="03" name="Inhibit Time" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180203"/>
            <CANopenSubObject subIndex="04" name="Compatibility Entry" objectType="7" dataType="0005" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_180204"/>
            <CANopenSubObject subIndex="05" name="Event Timer" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180205"/>
          </CANopenObject>
          <CANopenObject index="1803" name="TPDO4 Communication Parameter" objectType="9" subNumber="6">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" accessType="ro" defaultValue="0x05" actualValue="0x05" PDOmapping="no" uniqueIDRef="UID_SUB_180300"/>
            <CANopenSubObject subIndex="01" name="COB-ID" objectType="7" dataType="0007" accessType="ro" defaultValue="0x0000048C" actualValue="0x0000048C" PDOmapping="no" uniqueIDRef="UID_SUB_180301"/>
            <CANopenSubObject subIndex="02" name="Transmission Type" objectType="7" dataType="0005" accessType="ro" defaultValue="0xFE" actualValue="0xFE" PDOmapping="no" uniqueIDRef="UID_SUB_180302"/>
            <CANopenSubObject subIndex="03" name="Inhibit Time" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180303"/>
            <CANopenSubObject subIndex="04" name="Compatibility Entry" objectType="7" dataType="0005" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_180304"/>
            <CANopenSubObject subIndex="05" name="Event Timer" objectType="7" dataType="0006" accessType="ro" defaultValue="0x007D" actualValue="0x007D" PDOmapping="no" uniqueIDRef="UID_SUB_180305"/>
          </CANopenObject>
          <CANopenObject index="1804" name="TPDO5 Communication Parameter" objectType="9" subNumber="6">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" accessType="ro" defaultValue="0x05" actualValue="0x05" PDOmapping="no" uniqueIDRef="UID_SUB_180400"/>
            <CANopenSubObject subIndex="01" name="COB-ID" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000680" actualValue="0x00000680" PDOmapping="no" uniqueIDRef="UID_SUB_180401"/>
            <CANopenSubObject subIndex="02" name="Transmission Type" objectType="7" dataType="0005" accessType="ro" defaultValue="0xFE" actualValue="0xFE" PDOmapping="no" uniqueIDRef="UID_SUB_180402"/>
            <CANopenSubObject subIndex="03" name="Inhibit Time" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180403"/>
            <CANopenSubObject subIndex="04" name="Compatibility Entry" objectType="7" dataType="0005" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_180404"/>
            <CANopenSubObject subIndex="05" name="Event Timer" objectType="7" dataType="0006" accessType="ro" defaultValue="0x01F4" actualValue="0x01F4" PDOmapping="no" uniqueIDRef="UID_SUB_180405"/>
          </CANopenObject>
          <CANopenObject index="1805" name="TPDO6 Communication Parameter" objectType="9" subNumber="6">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" accessType="ro" defaultValue="0x05" actualValue="0x05" PDOmapping="no" uniqueIDRef="UID_SUB_180500"/>
            <CANopenSubObject subIndex="01" name="COB-ID" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000681" actualValue="0x00000681" PDOmapping="no" uniqueIDRef="UID_SUB_180501"/>
            <CANopenSubObject subIndex="02" name="Transmission Type" objectType="7" dataType="0005" accessType="ro" defaultValue="0xFE" actualValue="0xFE" PDOmapping="no" uniqueIDRef="UID_SUB_180502"/>
            <CANopenSubObject subIndex="03" name="Inhibit Time" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180503"/>
            <CANopenSubObject subIndex="04" name="Compatibility Entry" objectType="7" dataType="0005" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_180504"/>
            <CANopenSubObject subIndex="05" name="Event Timer" objectType="7" dataType="0006" accessType="ro" defaultValue="0x03E8" actualValue="0x03E8" PDOmapping="no" uniqueIDRef="UID_SUB_180505"/>
          </CANopenObject>
          <CANopenObject index="1806" name="TPDO7 Communication Parameter" objectType="9" subNumber="6">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" accessType="ro" defaultValue="0x05" actualValue="0x05" PDOmapping="no" uniqueIDRef="UID_SUB_180600"/>
            <CANopenSubObject subIndex="01" name="COB-ID" objectType="7" dataType="0007" accessType="ro" defaultValue="0x80000000" actualValue="0x80000000" PDOmapping="no" uniqueIDRef="UID_SUB_180601"/>
            <CANopenSubObject subIndex="02" name="Transmission Type" objectType="7" dataType="0005" accessType="ro" defaultValue="0xFE" actualValue="0xFE" PDOmapping="no" uniqueIDRef="UID_SUB_180602"/>
            <CANopenSubObject subIndex="03" name="Inhibit Time" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180603"/>
            <CANopenSubObject subIndex="04" name="Compatibility Entry" objectType="7" dataType="0005" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_180604"/>
            <CANopenSubObject subIndex="05" name="Event Timer" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180605"/>
          </CANopenObject>
          <CANopenObject index="1807" name="TPDO8 Communication Parameter" objectType="9" subNumber="6">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" accessType="ro" defaultValue="0x05" actualValue="0x05" PDOmapping="no" uniqueIDRef="UID_SUB_180700"/>
            <CANopenSubObject subIndex="01" name="COB-ID" objectType="7" dataType="0007" accessType="ro" defaultValue="0x80000000" actualValue="0x80000000" PDOmapping="no" uniqueIDRef="UID_SUB_180701"/>
            <CANopenSubObject subIndex="02" name="Transmission Type" objectType="7" dataType="0005" accessType="ro" defaultValue="0xFE" actualValue="0xFE" PDOmapping="no" uniqueIDRef="UID_SUB_180702"/>
            <CANopenSubObject subIndex="03" name="Inhibit Time" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180703"/>
            <CANopenSubObject subIndex="04" name="Compatibility Entry" objectType="7" dataType="0005" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_180704"/>
            <CANopenSubObject subIndex="05" name="Event Timer" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180705"/>
          </CANopenObject>
          <CANopenObject index="1808" name="TPDO9 Communication Parameter" objectType="9" subNumber="6">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" accessType="ro" defaultValue="0x05" actualValue="0x05" PDOmapping="no" uniqueIDRef="UID_SUB_180800"/>
            <CANopenSubObject subIndex="01" name="COB-ID" objectType="7" dataType="0007" accessType="ro" defaultValue="0x80000000" actualValue="0x80000000" PDOmapping="no" uniqueIDRef="UID_SUB_180801"/>
            <CANopenSubObject subIndex="02" name="Transmission Type" objectType="7" dataType="0005" accessType="ro" defaultValue="0xFE" actualValue="0xFE" PDOmapping="no" uniqueIDRef="UID_SUB_180802"/>
            <CANopenSubObject subIndex="03" name="Inhibit Time" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180803"/>
            <CANopenSubObject subIndex="04" name="Compatibility Entry" objectType="7" dataType="0005" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_180804"/>
            <CANopenSubObject subIndex="05" name="Event Timer" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180805"/>
          </CANopenObject>
          <CANopenObject index="1809" name="TPDO10 Communication Parameter" objectType="9" subNumber="6">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" accessType="ro" defaultValue="0x05" actualValue="0x05" PDOmapping="no" uniqueIDRef="UID_SUB_180900"/>
            <CANopenSubObject subIndex="01" name="COB-ID" objectType="7" dataType="0007" accessType="ro" defaultValue="0x80000000" actualValue="0x80000000" PDOmapping="no" uniqueIDRef="UID_SUB_180901"/>
            <CANopenSubObject subIndex="02" name="Transmission Type" objectType="7" dataType="0005" accessType="ro" defaultValue="0xFE" actualValue="0xFE" PDOmapping="no" uniqueIDRef="UID_SUB_180902"/>
            <CANopenSubObject subIndex="03" name="Inhibit Time" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180903"/>
            <CANopenSubObject subIndex="04" name="Compatibility Entry" objectType="7" dataType="0005" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_180904"/>
            <CANopenSubObject subIndex="05" name="Event Timer" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180905"/>
          </CANopenObject>
          <CANopenObject index="180A" name="TPDO11 Communication Parameter" objectType="9" subNumber="6">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" accessType="ro" defaultValue="0x05" actualValue="0x05" PDOmapping="no" uniqueIDRef="UID_SUB_180A00"/>
            <CANopenSubObject subIndex="01" name="COB-ID" objectType="7" dataType="0007" accessType="ro" defaultValue="0x80000000" actualValue="0x80000000" PDOmapping="no" uniqueIDRef="UID_SUB_180A01"/>
            <CANopenSubObject subIndex="02" name="Transmission Type" objectType="7" dataType="0005" accessType="ro" defaultValue="0xFE" actualValue="0xFE" PDOmapping="no" uniqueIDRef="UID_SUB_180A02"/>
            <CANopenSubObject subIndex="03" name="Inhibit Time" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180A03"/>
            <CANopenSubObject subIndex="04" name="Compatibility Entry" objectType="7" dataType="0005" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_180A04"/>
            <CANopenSubObject subIndex="05" name="Event Timer" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180A05"/>
          </CANopenObject>
          <CANopenObject index="180B" name="TPDO12 Communication Parameter" objectType="9" subNumber="6">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" accessType="ro" defaultValue="0x05" actualValue="0x05" PDOmapping="no" uniqueIDRef="UID_SUB_180B00"/>
            <CANopenSubObject subIndex="01" name="COB-ID" objectType="7" dataType="0007" accessType="ro" defaultValue="0x80000000" actualValue="0x80000000" PDOmapping="no" uniqueIDRef="UID_SUB_180B01"/>
            <CANopenSubObject subIndex="02" name="Transmission Type" objectType="7" dataType="0005" accessType="ro" defaultValue="0xFE" actualValue="0xFE" PDOmapping="no" uniqueIDRef="UID_SUB_180B02"/>
            <CANopenSubObject subIndex="03" name="Inhibit Time" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180B03"/>
            <CANopenSubObject subIndex="04" name="Compatibility Entry" objectType="7" dataType="0005" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_180B04"/>
            <CANopenSubObject subIndex="05" name="Event Timer" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180B05"/>
          </CANopenObject>
          <CANopenObject index="180C" name="TPDO13 Communication Parameter" objectType="9" subNumber="6">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" accessType="ro" defaultValue="0x05" actualValue="0x05" PDOmapping="no" uniqueIDRef="UID_SUB_180C00"/>
            <CANopenSubObject subIndex="01" name="COB-ID" objectType="7" dataType="0007" accessType="ro" defaultValue="0x80000000" actualValue="0x80000000" PDOmapping="no" uniqueIDRef="UID_SUB_180C01"/>
            <CANopenSubObject subIndex="02" name="Transmission Type" objectType="7" dataType="0005" accessType="ro" defaultValue="0xFE" actualValue="0xFE" PDOmapping="no" uniqueIDRef="UID_SUB_180C02"/>
            <CANopenSubObject subIndex="03" name="Inhibit Time" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180C03"/>
            <CANopenSubObject subIndex="04" name="Compatibility Entry" objectType="7" dataType="0005" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_180C04"/>
            <CANopenSubObject subIndex="05" name="Event Timer" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180C05"/>
          </CANopenObject>
          <CANopenObject index="180D" name="TPDO14 Communication Parameter" objectType="9" subNumber="6">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" accessType="ro" defaultValue="0x05" actualValue="0x05" PDOmapping="no" uniqueIDRef="UID_SUB_180D00"/>
            <CANopenSubObject subIndex="01" name="COB-ID" objectType="7" dataType="0007" accessType="ro" defaultValue="0x80000000" actualValue="0x80000000" PDOmapping="no" uniqueIDRef="UID_SUB_180D01"/>
            <CANopenSubObject subIndex="02" name="Transmission Type" objectType="7" dataType="0005" accessType="ro" defaultValue="0xFE" actualValue="0xFE" PDOmapping="no" uniqueIDRef="UID_SUB_180D02"/>
            <CANopenSubObject subIndex="03" name="Inhibit Time" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180D03"/>
            <CANopenSubObject subIndex="04" name="Compatibility Entry" objectType="7" dataType="0005" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_180D04"/>
            <CANopenSubObject subIndex="05" name="Event Timer" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180D05"/>
          </CANopenObject>
          <CANopenObject index="180E" name="TPDO15 Communication Parameter" objectType="9" subNumber="6">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" accessType="ro" defaultValue="0x05" actualValue="0x05" PDOmapping="no" uniqueIDRef="UID_SUB_180E00"/>
            <CANopenSubObject subIndex="01" name="COB-ID" objectType="7" dataType="0007" accessType="ro" defaultValue="0x80000000" actualValue="0x80000000" PDOmapping="no" uniqueIDRef="UID_SUB_180E01"/>
            <CANopenSubObject subIndex="02" name="Transmission Type" objectType="7" dataType="0005" accessType="ro" defaultValue="0xFE" actualValue="0xFE" PDOmapping="no" uniqueIDRef="UID_SUB_180E02"/>
            <CANopenSubObject subIndex="03" name="Inhibit Time" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180E03"/>
            <CANopenSubObject subIndex="04" name="Compatibility Entry" objectType="7" dataType="0005" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_180E04"/>
            <CANopenSubObject subIndex="05" name="Event Timer" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180E05"/>
          </CANopenObject>
          <CANopenObject index="180F" name="TPDO16 Communication Parameter" objectType="9" subNumber="6">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" accessType="ro" defaultValue="0x05" actualValue="0x05" PDOmapping="no" uniqueIDRef="UID_SUB_180F00"/>
            <CANopenSubObject subIndex="01" name="COB-ID" objectType="7" dataType="0007" accessType="ro" defaultValue="0x80000000" actualValue="0x80000000" PDOmapping="no" uniqueIDRef="UID_SUB_180F01"/>
            <CANopenSubObject subIndex="02" name="Transmission Type" objectType="7" dataType="0005" accessType="ro" defaultValue="0xFE" actualValue="0xFE" PDOmapping="no" uniqueIDRef="UID_SUB_180F02"/>
            <CANopenSubObject subIndex="03" name="Inhibit Time" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180F03"/>
            <CANopenSubObject subIndex="04" name="Compatibility Entry" objectType="7" dataType="0005" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_180F04"/>
            <CANopenSubObject subIndex="05" name="Event Timer" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" actualValue="0x0000" PDOmapping="no" uniqueIDRef="UID_SUB_180F05"/>
          </CANopenObject>
          <CANopenObject index="1A00" name="TPDO1 Mapping Parameter" objectType="9" subNumber="5">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" lowLimit="0x00" highLimit="0x04" accessType="ro" defaultValue="0x04" actualValue="0x04" PDOmapping="no" uniqueIDRef="UID_SUB_1A0000"/>
            <CANopenSubObject subIndex="01" name="Mapped Object 1" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20000110" actualValue="0x20000110" PDOmapping="no" uniqueIDRef="UID_SUB_1A0001"/>
            <CANopenSubObject subIndex="02" name="Mapped Object 2" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20000210" actualValue="0x20000210" PDOmapping="no" uniqueIDRef="UID_SUB_1A0002"/>
            <CANopenSubObject subIndex="03" name="Mapped Object 3" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20000310" actualValue="0x20000310" PDOmapping="no" uniqueIDRef="UID_SUB_1A0003"/>
            <CANopenSubObject subIndex="04" name="Mapped Object 4" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20000410" actualValue="0x20000410" PDOmapping="no" uniqueIDRef="UID_SUB_1A0004"/>
          </CANopenObject>
          <CANopenObject index="1A01" name="TPDO2 Mapping Parameter" objectType="9" subNumber="3">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" lowLimit="0x00" highLimit="0x02" accessType="ro" defaultValue="0x02" actualValue="0x02" PDOmapping="no" uniqueIDRef="UID_SUB_1A0100"/>
            <CANopenSubObject subIndex="01" name="Mapped Object 1" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20000510" actualValue="0x20000510" PDOmapping="no" uniqueIDRef="UID_SUB_1A0101"/>
            <CANopenSubObject subIndex="02" name="Mapped Object 2" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20000610" actualValue="0x20000610" PDOmapping="no" uniqueIDRef="UID_SUB_1A0102"/>
          </CANopenObject>
          <CANopenObject index="1A02" name="TPDO3 Mapping Parameter" objectType="9" subNumber="2">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" lowLimit="0x00" highLimit="0x01" accessType="ro" defaultValue="0x01" actualValue="0x01" PDOmapping="no" uniqueIDRef="UID_SUB_1A0200"/>
            <CANopenSubObject subIndex="01" name="Mapped Object 1" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20000710" actualValue="0x20000710" PDOmapping="no" uniqueIDRef="UID_SUB_1A0201"/>
          </CANopenObject>
          <CANopenObject index="1A03" name="TPDO4 Mapping Parameter" objectType="9" subNumber="5">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" lowLimit="0x00" highLimit="0x04" accessType="ro" defaultValue="0x04" actualValue="0x04" PDOmapping="no" uniqueIDRef="UID_SUB_1A0300"/>
            <CANopenSubObject subIndex="01" name="Mapped Object 1" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20010110" actualValue="0x20010110" PDOmapping="no" uniqueIDRef="UID_SUB_1A0301"/>
            <CANopenSubObject subIndex="02" name="Mapped Object 2" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20010210" actualValue="0x20010210" PDOmapping="no" uniqueIDRef="UID_SUB_1A0302"/>
            <CANopenSubObject subIndex="03" name="Mapped Object 3" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20010310" actualValue="0x20010310" PDOmapping="no" uniqueIDRef="UID_SUB_1A0303"/>
            <CANopenSubObject subIndex="04" name="Mapped Object 4" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20010410" actualValue="0x20010410" PDOmapping="no" uniqueIDRef="UID_SUB_1A0304"/>
          </CANopenObject>
          <CANopenObject index="1A04" name="TPDO5 Mapping Parameter" objectType="9" subNumber="5">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" lowLimit="0x00" highLimit="0x04" accessType="ro" defaultValue="0x04" actualValue="0x04" PDOmapping="no" uniqueIDRef="UID_SUB_1A0400"/>
            <CANopenSubObject subIndex="01" name="Mapped Object 1" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20010510" actualValue="0x20010510" PDOmapping="no" uniqueIDRef="UID_SUB_1A0401"/>
            <CANopenSubObject subIndex="02" name="Mapped Object 2" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20010610" actualValue="0x20010610" PDOmapping="no" uniqueIDRef="UID_SUB_1A0402"/>
            <CANopenSubObject subIndex="03" name="Mapped Object 3" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20010710" actualValue="0x20010710" PDOmapping="no" uniqueIDRef="UID_SUB_1A0403"/>
            <CANopenSubObject subIndex="04" name="Mapped Object 4" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20010810" actualValue="0x20010810" PDOmapping="no" uniqueIDRef="UID_SUB_1A0404"/>
          </CANopenObject>
          <CANopenObject index="1A05" name="TPDO6 Mapping Parameter" objectType="9" subNumber="5">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" lowLimit="0x00" highLimit="0x04" accessType="ro" defaultValue="0x04" actualValue="0x04" PDOmapping="no" uniqueIDRef="UID_SUB_1A0500"/>
            <CANopenSubObject subIndex="01" name="Mapped Object 1" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20010910" actualValue="0x20010910" PDOmapping="no" uniqueIDRef="UID_SUB_1A0501"/>
            <CANopenSubObject subIndex="02" name="Mapped Object 2" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20010A10" actualValue="0x20010A10" PDOmapping="no" uniqueIDRef="UID_SUB_1A0502"/>
            <CANopenSubObject subIndex="03" name="Mapped Object 3" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20010B10" actualValue="0x20010B10" PDOmapping="no" uniqueIDRef="UID_SUB_1A0503"/>
            <CANopenSubObject subIndex="04" name="Mapped Object 4" objectType="7" dataType="0007" accessType="ro" defaultValue="0x20010C10" actualValue="0x20010C10" PDOmapping="no" uniqueIDRef="UID_SUB_1A0504"/>
          </CANopenObject>
          <CANopenObject index="1A06" name="TPDO7 Mapping Parameter" objectType="9" subNumber="5">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" lowLimit="0x00" highLimit="0x04" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_1A0600"/>
            <CANopenSubObject subIndex="01" name="Mapped Object 1" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0601"/>
            <CANopenSubObject subIndex="02" name="Mapped Object 2" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0602"/>
            <CANopenSubObject subIndex="03" name="Mapped Object 3" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0603"/>
            <CANopenSubObject subIndex="04" name="Mapped Object 4" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0604"/>
          </CANopenObject>
          <CANopenObject index="1A07" name="TPDO8 Mapping Parameter" objectType="9" subNumber="5">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" lowLimit="0x00" highLimit="0x04" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_1A0700"/>
            <CANopenSubObject subIndex="01" name="Mapped Object 1" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0701"/>
            <CANopenSubObject subIndex="02" name="Mapped Object 2" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0702"/>
            <CANopenSubObject subIndex="03" name="Mapped Object 3" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0703"/>
            <CANopenSubObject subIndex="04" name="Mapped Object 4" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0704"/>
          </CANopenObject>
          <CANopenObject index="1A08" name="TPDO9 Mapping Parameter" objectType="9" subNumber="5">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" lowLimit="0x00" highLimit="0x04" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_1A0800"/>
            <CANopenSubObject subIndex="01" name="Mapped Object 1" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0801"/>
            <CANopenSubObject subIndex="02" name="Mapped Object 2" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0802"/>
            <CANopenSubObject subIndex="03" name="Mapped Object 3" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0803"/>
            <CANopenSubObject subIndex="04" name="Mapped Object 4" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0804"/>
          </CANopenObject>
          <CANopenObject index="1A09" name="TPDO10 Mapping Parameter" objectType="9" subNumber="5">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" lowLimit="0x00" highLimit="0x04" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_1A0900"/>
            <CANopenSubObject subIndex="01" name="Mapped Object 1" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0901"/>
            <CANopenSubObject subIndex="02" name="Mapped Object 2" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0902"/>
            <CANopenSubObject subIndex="03" name="Mapped Object 3" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0903"/>
            <CANopenSubObject subIndex="04" name="Mapped Object 4" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0904"/>
          </CANopenObject>
          <CANopenObject index="1A0A" name="TPDO11 Mapping Parameter" objectType="9" subNumber="5">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" lowLimit="0x00" highLimit="0x04" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_1A0A00"/>
            <CANopenSubObject subIndex="01" name="Mapped Object 1" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0A01"/>
            <CANopenSubObject subIndex="02" name="Mapped Object 2" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0A02"/>
            <CANopenSubObject subIndex="03" name="Mapped Object 3" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0A03"/>
            <CANopenSubObject subIndex="04" name="Mapped Object 4" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0A04"/>
          </CANopenObject>
          <CANopenObject index="1A0B" name="TPDO12 Mapping Parameter" objectType="9" subNumber="5">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" lowLimit="0x00" highLimit="0x04" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_1A0B00"/>
            <CANopenSubObject subIndex="01" name="Mapped Object 1" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0B01"/>
            <CANopenSubObject subIndex="02" name="Mapped Object 2" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0B02"/>
            <CANopenSubObject subIndex="03" name="Mapped Object 3" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0B03"/>
            <CANopenSubObject subIndex="04" name="Mapped Object 4" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0B04"/>
          </CANopenObject>
          <CANopenObject index="1A0C" name="TPDO13 Mapping Parameter" objectType="9" subNumber="5">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" lowLimit="0x00" highLimit="0x04" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_1A0C00"/>
            <CANopenSubObject subIndex="01" name="Mapped Object 1" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0C01"/>
            <CANopenSubObject subIndex="02" name="Mapped Object 2" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0C02"/>
            <CANopenSubObject subIndex="03" name="Mapped Object 3" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0C03"/>
            <CANopenSubObject subIndex="04" name="Mapped Object 4" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0C04"/>
          </CANopenObject>
          <CANopenObject index="1A0D" name="TPDO14 Mapping Parameter" objectType="9" subNumber="5">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" lowLimit="0x00" highLimit="0x04" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_1A0D00"/>
            <CANopenSubObject subIndex="01" name="Mapped Object 1" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0D01"/>
            <CANopenSubObject subIndex="02" name="Mapped Object 2" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0D02"/>
            <CANopenSubObject subIndex="03" name="Mapped Object 3" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0D03"/>
            <CANopenSubObject subIndex="04" name="Mapped Object 4" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0D04"/>
          </CANopenObject>
          <CANopenObject index="1A0E" name="TPDO15 Mapping Parameter" objectType="9" subNumber="5">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" lowLimit="0x00" highLimit="0x04" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_1A0E00"/>
            <CANopenSubObject subIndex="01" name="Mapped Object 1" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0E01"/>
            <CANopenSubObject subIndex="02" name="Mapped Object 2" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0E02"/>
            <CANopenSubObject subIndex="03" name="Mapped Object 3" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0E03"/>
            <CANopenSubObject subIndex="04" name="Mapped Object 4" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0E04"/>
          </CANopenObject>
          <CANopenObject index="1A0F" name="TPDO16 Mapping Parameter" objectType="9" subNumber="5">
            <CANopenSubObject subIndex="00" name="Number of Entries" objectType="7" dataType="0005" lowLimit="0x00" highLimit="0x04" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_1A0F00"/>
            <CANopenSubObject subIndex="01" name="Mapped Object 1" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0F01"/>
            <CANopenSubObject subIndex="02" name="Mapped Object 2" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0F02"/>
            <CANopenSubObject subIndex="03" name="Mapped Object 3" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0F03"/>
            <CANopenSubObject subIndex="04" name="Mapped Object 4" objectType="7" dataType="0007" accessType="ro" defaultValue="0x00000000" actualValue="0x00000000" PDOmapping="no" uniqueIDRef="UID_SUB_1A0F04"/>
          </CANopenObject>
          <CANopenObject index="2000" name="Digital Outputs" objectType="8" subNumber="8">
            <CANopenSubObject subIndex="00" name="Number of entries" objectType="7" dataType="0005" lowLimit="0x06" highLimit="0x07" accessType="ro" defaultValue="0x07" actualValue="0x07" PDOmapping="no" uniqueIDRef="UID_SUB_200000"/>
            <CANopenSubObject subIndex="01" name="Errors 0-15" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" PDOmapping="TPDO" uniqueIDRef="UID_SUB_200001"/>
            <CANopenSubObject subIndex="02" name="Errors 16-31" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" PDOmapping="TPDO" uniqueIDRef="UID_SUB_200002"/>
            <CANopenSubObject subIndex="03" name="Errors 32-47" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" PDOmapping="TPDO" uniqueIDRef="UID_SUB_200003"/>
            <CANopenSubObject subIndex="04" name="Errors 48-63" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" PDOmapping="TPDO" uniqueIDRef="UID_SUB_200004"/>
            <CANopenSubObject subIndex="05" name="Errors 64-79" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" PDOmapping="TPDO" uniqueIDRef="UID_SUB_200005"/>
            <CANopenSubObject subIndex="06" name="Errors 80-95" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" PDOmapping="TPDO" uniqueIDRef="UID_SUB_200006"/>
            <CANopenSubObject subIndex="07" name="Engine State" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" PDOmapping="TPDO" uniqueIDRef="UID_SUB_200007"/>
          </CANopenObject>
          <CANopenObject index="2001" name="Unsigned Analog Outputs" objectType="8" subNumber="13">
            <CANopenSubObject subIndex="00" name="Number of entries" objectType="7" dataType="0005" lowLimit="0x00" highLimit="0x34" accessType="ro" defaultValue="0x0C" actualValue="0x0C" PDOmapping="no" uniqueIDRef="UID_SUB_200100"/>
            <CANopenSubObject subIndex="01" name="Speed" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" PDOmapping="TPDO" uniqueIDRef="UID_SUB_200101"/>
            <CANopenSubObject subIndex="02" name="SpeedSetp" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" PDOmapping="TPDO" uniqueIDRef="UID_SUB_200102"/>
            <CANopenSubObject subIndex="03" name="ActPos" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" PDOmapping="TPDO" uniqueIDRef="UID_SUB_200103"/>
            <CANopenSubObject subIndex="04" name="MeasuredPower" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" PDOmapping="TPDO" uniqueIDRef="UID_SUB_200104"/>
            <CANopenSubObject subIndex="05" name="BoostPressure" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" PDOmapping="TPDO" uniqueIDRef="UID_SUB_200105"/>
            <CANopenSubObject subIndex="06" name="OilPressure" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" PDOmapping="TPDO" uniqueIDRef="UID_SUB_200106"/>
            <CANopenSubObject subIndex="07" name="AmbientPressure" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" PDOmapping="TPDO" uniqueIDRef="UID_SUB_200107"/>
            <CANopenSubObject subIndex="08" name="CoolantPressure" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" PDOmapping="TPDO" uniqueIDRef="UID_SUB_200108"/>
            <CANopenSubObject subIndex="09" name="CoolantTemp" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" PDOmapping="TPDO" uniqueIDRef="UID_SUB_200109"/>
            <CANopenSubObject subIndex="0A" name="ChargeAirTemp" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" PDOmapping="TPDO" uniqueIDRef="UID_SUB_20010A"/>
            <CANopenSubObject subIndex="0B" name="OilTemp" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" PDOmapping="TPDO" uniqueIDRef="UID_SUB_20010B"/>
            <CANopenSubObject subIndex="0C" name="ExhaustTemp" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" PDOmapping="TPDO" uniqueIDRef="UID_SUB_20010C"/>
          </CANopenObject>
          <CANopenObject index="2002" name="Signed Analog Outputs" objectType="8" subNumber="1">
            <CANopenSubObject subIndex="00" name="Number of entries" objectType="7" dataType="0005" lowLimit="0x00" highLimit="0x34" accessType="ro" defaultValue="0x00" actualValue="0x00" PDOmapping="no" uniqueIDRef="UID_SUB_200200"/>
          </CANopenObject>
          <CANopenObject index="2003" name="Digital Inputs" objectType="8" subNumber="3">
            <CANopenSubObject subIndex="00" name="Number of entries" objectType="7" dataType="0005" lowLimit="0x00" highLimit="0x02" accessType="ro" defaultValue="0x02" actualValue="0x02" PDOmapping="no" uniqueIDRef="UID_SUB_200300"/>
            <CANopenSubObject subIndex="01" name="Switch Functions" objectType="7" dataType="0006" accessType="rw" defaultValue="0x0000" PDOmapping="RPDO" uniqueIDRef="UID_SUB_200301"/>
            <CANopenSubObject subIndex="02" name="Sensor Error Flags" objectType="7" dataType="0006" accessType="rw" defaultValue="0x0000" PDOmapping="RPDO" uniqueIDRef="UID_SUB_200302"/>
          </CANopenObject>
          <CANopenObject index="2004" name="Analog Inputs" objectType="8" subNumber="10">
            <CANopenSubObject subIndex="00" name="Number of entries" objectType="7" dataType="0005" lowLimit="0x00" highLimit="0x0C" accessType="ro" defaultValue="0x09" actualValue="0x09" PDOmapping="no" uniqueIDRef="UID_SUB_200400"/>
            <CANopenSubObject subIndex="01" name="AssignIn_Setp1Ext" objectType="7" dataType="0006" accessType="rw" defaultValue="0x0000" PDOmapping="RPDO" uniqueIDRef="UID_SUB_200401"/>
            <CANopenSubObject subIndex="02" name="Sensor 902" objectType="7" dataType="0006" accessType="rw" defaultValue="0x0000" PDOmapping="RPDO" uniqueIDRef="UID_SUB_200402"/>
            <CANopenSubObject subIndex="03" name="Sensor 903" objectType="7" dataType="0006" accessType="rw" defaultValue="0x0000" PDOmapping="RPDO" uniqueIDRef="UID_SUB_200403"/>
            <CANopenSubObject subIndex="04" name="Unused Channel 4" objectType="7" dataType="0006" accessType="rw" defaultValue="0x0000" PDOmapping="RPDO" uniqueIDRef="UID_SUB_200404"/>
            <CANopenSubObject subIndex="05" name="AssignIn_AmbPress" objectType="7" dataType="0006" accessType="rw" defaultValue="0x0000" PDOmapping="RPDO" uniqueIDRef="UID_SUB_200405"/>
            <CANopenSubObject subIndex="06" name="Sensor 910" objectType="7" dataType="0006" accessType="rw" defaultValue="0x0000" PDOmapping="RPDO" uniqueIDRef="UID_SUB_200406"/>
            <CANopenSubObject subIndex="07" name="Unused Channel 7" objectType="7" dataType="0006" accessType="rw" defaultValue="0x0000" PDOmapping="RPDO" uniqueIDRef="UID_SUB_200407"/>
            <CANopenSubObject subIndex="08" name="Unused Channel 8" objectType="7" dataType="0006" accessType="rw" defaultValue="0x0000" PDOmapping="RPDO" uniqueIDRef="UID_SUB_200408"/>
            <CANopenSubObject subIndex="09" name="AssignIn_CurrentLoad" objectType="7" dataType="0006" accessType="rw" defaultValue="0x0000" PDOmapping="RPDO" uniqueIDRef="UID_SUB_200409"/>
          </CANopenObject>
          <CANopenObject index="2005" name="CanOpen Errors" objectType="7" dataType="0006" accessType="ro" defaultValue="0x0000" PDOmapping="no" uniqueIDRef="UID_OBJ_2005"/>
        </co:CANopenObjectList>
        <dummyUsage>
          <dummy entry="Dummy0001=0"/>
          <dummy entry="Dummy0002=0"/>
          <dummy entry="Dummy0003=0"/>
          <dummy entry="Dummy0004=0"/>
          <dummy entry="Dummy0005=0"/>
          <dummy entry="Dummy0006=1"/>
          <dummy entry="Dummy0007=0"/>
        </dummyUsage>
      </ApplicationLayers>
      <TransportLayers>
        <PhysicalLayer>
          <baudRate>
            <supportedBaudRate value="125 Kbps"/>
            <supportedBaudRate value="250 Kbps"/>
            <supportedBaudRate value="500 Kbps"/>
            <supportedBaudRate value="1000 Kbps"/>
          </baudRate>
        </PhysicalLayer>
      </TransportLayers>
      <NetworkManagement>
        <CANopenGeneralFeatures groupMessaging="false" dynamicChannels="0" granularity="0" nrOfRxPDO="4" nrOfTxPDO="16" bootUpSlave="true" layerSettingServiceSlave="false"/>
        <CANopenMasterFeatures bootUpMaster="false"/>
        <deviceCommissioning NodeID="12" nodeName="Genset 2, starboard" actualBaudRate="250" networkNumber="0" networkName="" CANopenManager="false"/>
      </NetworkManagement>
    </ProfileBody>
  </ISO15745Profile>
</ISO15745ProfileContainer>
